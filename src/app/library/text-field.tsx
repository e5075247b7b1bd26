import { useSignal } from '@preact/signals';
import { useEffect, useId, useRef } from 'preact/hooks';
import { libraryMessages } from '../messages/library.js';
import './text-field.css';

interface TextFieldProps {
  readonly label: string;
  /** What the library holds. */
  readonly value: string;
  readonly longest: number;
  /** Keeps what was typed; an empty text may be refused. */
  readonly onSave: (text: string) => void;
  readonly lines?: number;
  readonly required?: boolean;
  readonly hint?: string;
  readonly placeholder?: string;
  readonly hiddenLabel?: boolean;
}

/** So long after the last key a text is kept, in milliseconds: also when the page is left, and with the field. */
const REST = 600;

/** A text of the library that is kept as it is typed. What another tab saves in the same place meanwhile is told. */
export function TextField(props: TextFieldProps) {
  const { label, value, longest, onSave, lines, required, hint, placeholder, hiddenLabel } = props;
  const words = libraryMessages.value;
  const id = useId();
  /** What is typed, and what the library held then; null while the library is shown. */
  const typed = useSignal<{ readonly text: string; readonly from: string } | null>(null);
  const theirs = useSignal<string | null>(null);
  const rest = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const latest = useRef(props);
  latest.current = props;
  const keep = (): void => {
    clearTimeout(rest.current);
    const { value: held, required: must, onSave: save } = latest.current;
    const now = typed.peek();
    if (!now || (must && now.text.trim() === '')) return;
    if (held !== now.from && held !== now.text) theirs.value = held;
    if (held !== now.text) save(must ? now.text.trim() : now.text);
    typed.value = { text: now.text, from: now.text };
  };
  const leave = (): void => {
    keep();
    typed.value = null;
  };
  useEffect(() => {
    const keepNow = (): void => keep();
    addEventListener('pagehide', keepNow);
    document.addEventListener('visibilitychange', keepNow);
    return () => {
      removeEventListener('pagehide', keepNow);
      document.removeEventListener('visibilitychange', keepNow);
      keep();
    };
  }, []);
  const given = {
    id,
    placeholder,
    maxLength: longest,
    value: typed.value?.text ?? value,
    onInput: (event: { readonly currentTarget: { readonly value: string } }): void => {
      typed.value = { text: event.currentTarget.value, from: typed.peek()?.from ?? value };
      clearTimeout(rest.current);
      rest.current = setTimeout(keep, REST);
    },
    onBlur: leave,
  };
  const other = theirs.value;
  return (
    <div class="text-field">
      <label class={hiddenLabel ? 'visually-hidden' : undefined} for={id}>
        {label}
      </label>
      {lines ? <textarea {...given} rows={lines} /> : <input type="text" {...given} autocomplete="off" />}
      {hint && <p class="hint">{hint}</p>}
      {required && typed.value?.text.trim() === '' && <p class="bad-text">{words.nameNeeded}</p>}
      {other !== null && (
        <p class="text-theirs" role="status">
          {words.theirs(other)}{' '}
          <button
            type="button"
            class="quiet"
            onClick={() => {
              theirs.value = null;
              onSave(other);
            }}
          >
            {words.takeTheirs}
          </button>
        </p>
      )}
    </div>
  );
}
