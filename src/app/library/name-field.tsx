import { LIMITS } from '../../program/index.js';
import './library-form.css';

interface NameFieldProps {
  readonly label: string;
  readonly value: string;
  readonly placeholder?: string;
  readonly onChange: (text: string) => void;
}

/** A name in a dialog, which cannot be empty. */
export function NameField({ label, value, placeholder, onChange }: NameFieldProps) {
  return (
    <label class="field">
      <span>{label}</span>
      <input
        type="text"
        autofocus
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
