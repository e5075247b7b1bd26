import { useEffect, useRef } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { useCopy } from './use-copy.js';
import './modal.css';
import './copy-button.css';

interface CopyButtonProps {
  readonly label: string;
  /** Called on a click. */
  readonly text: () => string;
}

/** Copies a text. Where the browser does not allow it, shows the text, selected, so that the pilot can copy it. */
export function CopyButton({ label, text }: CopyButtonProps) {
  const { copied, refused, copy, forget } = useCopy(text);
  return (
    <span class="copy-button">
      {/* The text to copy by hand takes the focus from here, and stays. */}
      <button type="button" onClick={() => void copy()} onBlur={() => copied.value && forget()}>
        {label}
      </button>
      <span role="status">{copied.value && messages.value.copied}</span>
      {refused.value !== null && <ByHand text={refused.value} onClose={forget} />}
    </span>
  );
}

function ByHand({ text, onClose }: { text: string; onClose: () => void }) {
  const { line } = messages.value;
  const dialog = useRef<HTMLDialogElement>(null);
  const area = useRef<HTMLTextAreaElement>(null);
  useEffect(() => {
    dialog.current?.showModal();
    area.current?.select();
    area.current?.scrollTo(0, 0);
  }, []);
  return (
    <dialog ref={dialog} class="dialog by-hand" aria-label={line.copyByHand} onClose={onClose}>
      <p>{line.copyByHand}</p>
      <textarea ref={area} readOnly aria-label={line.copyByHand} rows={12} value={text} />
      <div class="buttons">
        <button type="button" class="primary" onClick={() => dialog.current?.close()}>
          {messages.value.close}
        </button>
      </div>
    </dialog>
  );
}
