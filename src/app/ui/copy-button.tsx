import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { copyText } from '../browser/clipboard.js';
import { messages } from '../messages/index.js';
import './modal.css';
import './copy-button.css';

interface CopyButtonProps {
  readonly label: string;
  /** Called on a click. */
  readonly text: () => string;
}

/** Copies a text. Where the browser does not allow it, shows the text, selected, so that the pilot can copy it. */
export function CopyButton({ label, text }: CopyButtonProps) {
  const copied = useSignal(false);
  /** The text that the browser did not copy. */
  const refused = useSignal<string | null>(null);
  const copy = async (): Promise<void> => {
    const made = text();
    copied.value = false;
    try {
      await copyText(made);
      copied.value = true;
    } catch {
      refused.value = made;
    }
  };
  return (
    <span class="copy-button">
      <button type="button" onClick={() => void copy()} onBlur={() => (copied.value = false)}>
        {label}
      </button>
      <span role="status">{copied.value && messages.value.copied}</span>
      {refused.value !== null && <ByHand text={refused.value} onClose={() => (refused.value = null)} />}
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
