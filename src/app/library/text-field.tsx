import { useSignal } from '@preact/signals';
import { useEffect, useId, useRef } from 'preact/hooks';
import { on } from '../browser/lifecycle.js';
import { moreMessages } from '../messages/more.js';
import { useUnsaved } from '../ui/unsaved.js';

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

/**
 * How long after the last key a text is saved, in milliseconds. It is also saved when the page or the field goes away.
 */
const REST = 600;

const asTyped = (text: string): string => text;

/** A text of the library that is saved while it is typed. */
export function TextField(props: TextFieldProps) {
  const { label, value, longest, lines, required, asKept = asTyped } = props;
  const words = moreMessages.value.library;
  const id = useId();
  /** The typed text; null while the library's text is shown. */
  const typed = useSignal<string | null>(null);
  const rest = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const latest = useRef(props);
  latest.current = props;
  const keep = (): void => {
    clearTimeout(rest.current);
    const { value: held, required: must, onSave: save, asKept = asTyped } = latest.current;
    const now = typed.peek();
    if (now === null) return;
    const kept = asKept(now);
    if (must && kept === '') return;
    if (held !== kept) save(kept);
  };
  const leave = (): void => {
    keep();
    typed.value = null;
  };
  useEffect(() => {
    const end = on('hide', keep);
    return () => {
      end();
      keep();
    };
  }, []);
  const given = {
    id,
    maxLength: longest,
    value: typed.value ?? value,
    onInput: (event: { readonly currentTarget: { readonly value: string } }): void => {
      typed.value = event.currentTarget.value;
      clearTimeout(rest.current);
      rest.current = setTimeout(keep, REST);
    },
    onBlur: leave,
  };
  // A reload would take the field from under the pilot's fingers.
  useUnsaved(typed.value !== null);
  return (
    <div class="field">
      <label for={id}>{label}</label>
      {lines ? <textarea {...given} rows={lines} /> : <input type="text" {...given} autocomplete="off" />}
      {required && typed.value !== null && asKept(typed.value) === '' && <p class="bad-text">{words.nameNeeded}</p>}
    </div>
  );
}
