import { useSignal } from '@preact/signals';
import { copyText } from '../browser/clipboard.js';
import { messages } from '../messages/index.js';
import { Modal } from './modal.js';
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
    <span class="row copy-button">
      <button type="button" onClick={() => void copy()} onBlur={() => (copied.value = false)}>
        {label}
      </button>
      <span role="status">{copied.value && messages.value.copied}</span>
      {refused.value !== null && <ByHand text={refused.value} onClose={() => (refused.value = null)} />}
    </span>
  );
}

function ByHand({ text, onClose }: { text: string; onClose: () => void }) {
  const { copyByHand, close } = messages.value;
  return (
    <Modal open title={copyByHand} onEscape={onClose}>
      <textarea
        autofocus
        readOnly
        class="by-hand"
        aria-label={copyByHand}
        rows={12}
        value={text}
        onFocus={({ currentTarget }) => currentTarget.select()}
      />
      <div class="buttons">
        <button type="button" class="primary" onClick={onClose}>
          {close}
        </button>
      </div>
    </Modal>
  );
}
