import { useEffect, useRef } from 'preact/hooks';
import { LIMITS } from '../../program/index.js';
import { on } from '../browser/lifecycle.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import { givenName, nameMemory } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import './memory-name.css';

/** The pilot's name for a memory of the model. Shows nothing while the model is not known. */
export function MemoryName({ session, memory }: { readonly session: Session; readonly memory: number }) {
  const { memoryNames: words } = moreMessages.value.whichModel;
  const input = useRef<HTMLInputElement>(null);
  const keep = ({ value }: HTMLInputElement): void => void nameMemory(session, memory, value);
  // What was typed is kept when the page goes, as when the field is left.
  useEffect(() => on('hide', () => input.current && keep(input.current)));
  const model = session.origin.named.value;
  if (!model) return null;
  const given = givenName(model, memory);
  return (
    <input
      ref={input}
      // A name that was changed elsewhere.
      key={given}
      type="text"
      class="memory-name"
      aria-label={words.label({ memory: memoryName(memory) })}
      placeholder={words.give}
      defaultValue={given}
      maxLength={LIMITS.name}
      autocomplete="off"
      onKeyDown={({ key, isComposing, currentTarget }) => {
        // These keys are for the list of characters that the keyboard offers.
        if (isComposing || !['Enter', 'Escape'].includes(key)) return;
        if (key === 'Escape') currentTarget.value = given;
        currentTarget.blur();
      }}
      onBlur={({ currentTarget }) => keep(currentTarget)}
    />
  );
}
