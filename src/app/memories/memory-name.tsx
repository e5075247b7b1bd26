import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { LIMITS } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { modelMessages } from '../messages/which-model.js';
import { givenName, nameMemory } from '../session/memory-names.js';
import type { Session } from '../session/session.js';
import './memory-name.css';

/** What the pilot calls a memory of his model; a press lets him change it. Nothing where the model is not known. */
export function MemoryName({ session, memory }: { readonly session: Session; readonly memory: number }) {
  const { memoryNames: words } = modelMessages.value;
  const { memoryName } = messages.value;
  const editing = useSignal(false);
  const box = useRef<HTMLSpanElement>(null);
  const was = useRef(false);
  const isEditing = editing.value;
  useEffect(() => {
    if (was.current === isEditing) return;
    was.current = isEditing;
    const input = box.current?.querySelector('input');
    input?.focus();
    input?.select();
    // The field that had the focus has gone; not where the pilot has gone elsewhere.
    if (!input && document.activeElement === document.body) box.current?.querySelector('button')?.focus();
  }, [isEditing]);
  const model = session.modelAtHand.value;
  if (!model) return null;
  const given = givenName(model, memory);
  const name = memoryName(memory);
  const end = (text: string | null): void => {
    if (!editing.value) return;
    editing.value = false;
    if (text !== null) void nameMemory(session, memory, text);
  };
  return (
    <span class="memory-name" ref={box}>
      {isEditing ? (
        <input
          type="text"
          aria-label={words.label(name)}
          defaultValue={given}
          maxLength={LIMITS.name}
          autocomplete="off"
          onKeyDown={(event) => {
            if (event.key === 'Enter') end(event.currentTarget.value);
            if (event.key === 'Escape') end(null);
          }}
          onBlur={(event) => end(event.currentTarget.value)}
        />
      ) : (
        <button
          type="button"
          class="quiet"
          aria-label={given === '' ? words.of(words.give, name) : words.change(name, given)}
          onClick={() => (editing.value = true)}
        >
          {given === '' ? words.give : given}
        </button>
      )}
    </span>
  );
}
