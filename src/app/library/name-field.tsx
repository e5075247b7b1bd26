import { LIMITS } from '../../program/index.js';
import './library-form.css';

interface NameFieldProps {
  readonly label: string;
  readonly value: string;
  readonly placeholder?: string;
  /** Whether it gets the focus when its dialog opens. Default true. */
  readonly first?: boolean;
  readonly onChange: (text: string) => void;
}

/** A name in a dialog, which cannot be empty. */
export function NameField({ label, value, placeholder, first = true, onChange }: NameFieldProps) {
  return (
    <label class="field">
      <span>{label}</span>
      <input
        type="text"
        autofocus={first}
        required
        pattern=".*\S.*"
        maxLength={LIMITS.name}
        autocomplete="off"
        placeholder={placeholder}
        value={value}
        onInput={(event) => onChange(event.currentTarget.value)}
      />
    </label>
  );
}
