import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { LIMITS } from '../../program/index.js';
import { on } from '../browser/lifecycle.js';
import { modelMessages } from '../messages/en-which-model.js';
import { messages } from '../messages/index.js';
import { givenName, nameMemory } from '../session/memory-names.js';
import type { Session } from '../session/session.js';
import { useUnsaved } from '../ui/unsaved.js';
import './memory-name.css';

/** The pilot's name for a memory of the model. A press edits it. Shows nothing while the model is not known. */
export function MemoryName({ session, memory }: { readonly session: Session; readonly memory: number }) {
  const { memoryNames: words } = modelMessages;
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
    // The field with the focus has gone. Not when the pilot has gone elsewhere.
    if (!input && document.activeElement === document.body) box.current?.querySelector('button')?.focus();
  }, [isEditing]);
  useUnsaved(isEditing);
  useEffect(() => {
    if (!isEditing) return undefined;
    // What was typed is kept when the page goes, as when the field is left.
    return on('hide', () => {
      const text = box.current?.querySelector('input')?.value;
      if (text !== undefined) void nameMemory(session, memory, text);
    });
  }, [isEditing, session, memory]);
  const model = session.origin.named.value;
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
            // These keys are for the list of characters that the keyboard offers.
            if (event.isComposing) return;
            if (event.key === 'Enter') end(event.currentTarget.value);
            if (event.key === 'Escape') end(null);
          }}
          onBlur={(event) => end(event.currentTarget.value)}
        />
      ) : (
        <button
          type="button"
          class="quiet"
          aria-label={given === '' ? messages.value.of(words.give, name) : words.change(name, given)}
          onClick={() => (editing.value = true)}
        >
          {given === '' ? words.give : given}
        </button>
      )}
    </span>
  );
}
