import { LIMITS } from '../../program/index.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import { useKeptText } from '../ui/kept-text.js';
import { givenName, nameMemory } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import './memory-name.css';

/** The pilot's name for a memory of the model. Shows nothing while the model is not known. */
export function MemoryName({ session, memory }: { readonly session: Session; readonly memory: number }) {
  const { memoryNames: words } = moreMessages.value.whichModel;
  const model = session.origin.named.value;
  const { given, drop } = useKeptText(givenName(model, memory), (name) => nameMemory(session, memory, name));
  if (!model) return null;
  return (
    <input
      {...given}
      type="text"
      class="memory-name"
      aria-label={words.label({ memory: memoryName(memory) })}
      placeholder={words.give}
      maxLength={LIMITS.name}
      onKeyDown={({ key, isComposing, currentTarget }) => {
        // These keys are for the list of characters that the keyboard offers.
        if (isComposing || !['Enter', 'Escape'].includes(key)) return;
        if (key === 'Escape') drop();
        currentTarget.blur();
      }}
    />
  );
}
