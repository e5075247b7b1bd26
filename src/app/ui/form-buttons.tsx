import { messages } from '../messages/index.js';

/** Leaves a dialog, and nothing is done. */
export function CancelButton({ onClick }: { readonly onClick: () => void }) {
  return (
    <button type="button" class="quiet" onClick={onClick}>
      {messages.value.cancel}
    </button>
  );
}

interface FormButtonsProps {
  /** What the form does. */
  readonly label: string;
  readonly disabled?: boolean;
  readonly onCancel: () => void;
}

/** The end of a form in a dialog: leaves it, or sends it. */
export function FormButtons({ label, disabled, onCancel }: FormButtonsProps) {
  return (
    <div class="buttons">
      <CancelButton onClick={onCancel} />
      <button type="submit" class="primary" disabled={disabled}>
        {label}
      </button>
    </div>
  );
}
