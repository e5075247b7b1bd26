import { useId } from 'preact/hooks';
import { moreMessages } from '../messages/more.js';
import { useKeptText } from '../ui/kept-text.js';

interface TextFieldProps {
  readonly label: string;
  /** The text in the library. */
  readonly value: string;
  readonly longest: number;
  /** Saves a text. */
  readonly onSave: (text: string) => void;
  /** The form in which the library keeps a typed text, such as a name without spaces around it. Default: as typed. */
  readonly asKept?: (text: string) => string;
  readonly lines?: number;
  readonly required?: boolean;
}

/** How long after the last key a text is saved, in milliseconds. */
const REST = 600;

/** A text of the library that is saved while it is typed. */
export function TextField({ label, value, longest, onSave, asKept = (text) => text, lines, required }: TextFieldProps) {
  const id = useId();
  const isMissing = (text: string): boolean => required === true && asKept(text) === '';
  const keep = (text: string): void => {
    const kept = asKept(text);
    if (!isMissing(text) && kept !== value) onSave(kept);
  };
  const { given } = useKeptText(value, keep, REST);
  return (
    <div class="field">
      <label for={id}>{label}</label>
      {lines ? (
        <textarea id={id} maxLength={longest} {...given} rows={lines} />
      ) : (
        <input id={id} type="text" maxLength={longest} {...given} />
      )}
      {isMissing(given.value) && <p class="bad-text">{moreMessages.value.library.nameNeeded}</p>}
    </div>
  );
}
