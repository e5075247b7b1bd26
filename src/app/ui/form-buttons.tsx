import type { ComponentChildren } from 'preact';
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
  /** Buttons before these. */
  readonly children?: ComponentChildren;
}

/** The end of a form in a dialog: leaves it, or sends it. */
export function FormButtons({ label, disabled, onCancel, children }: FormButtonsProps) {
  return (
    <div class="buttons">
      {children}
      <CancelButton onClick={onCancel} />
      <button type="submit" class="primary" disabled={disabled}>
        {label}
      </button>
    </div>
  );
}
