import { useId } from 'preact/hooks';
import { messages } from '../messages/index.js';
import { memoryName } from '../messages/names.js';
import { PlaneIcon } from '../ui/plane-icon.js';
import { givenName, memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import type { Memories } from './memories.js';
import './memory-choice.css';

/** With more memories, a list of one line takes the place of the row of buttons. */
const MOST_BUTTONS = 8;

/** Which memory flies next, in words, and which one is shown. Choosing one only shows it: nothing is sent. */
export function MemoryChoice({ session, memories }: { readonly session: Session; readonly memories: Memories }) {
  const { program, nextFlight } = messages.value;
  const { editor, onScreen, nextFlight: next, connection, runner } = session;
  const name = useId();
  const identity = editor.identity.value;
  // A program that was made here is for any timer.
  if (!identity || editor.madeAt.value !== null) return null;
  const isConnected = connection.value !== null;
  const job = runner.job.value;
  const flying = isConnected ? next.memory.value : null;
  const open = next.open.value && !onScreen.apart.value ? null : onScreen.memory.value;
  const shown = memories.looking.value ?? (job?.kind === 'select' ? job.memory : open);
  const nameOf = (index: number): string => {
    const text = memoryText(session, index);
    return index === flying ? nextFlight.named({ memory: text }) : text;
  };
  const all = Array.from({ length: identity.memories }, (_, index) => index);
  if (all.length > MOST_BUTTONS) {
    return (
      <select
        class="memories-list"
        aria-label={program.memory}
        disabled={!isConnected}
        value={String(shown ?? '')}
        onChange={({ currentTarget }) => void memories.show(Number(currentTarget.value))}
      >
        {shown === null && <option value="">{program.memory}</option>}
        {all.map((index) => (
          <option key={index} value={String(index)}>
            {nameOf(index)}
          </option>
        ))}
      </select>
    );
  }
  return (
    <fieldset class="memories">
      <legend class="visually-hidden">{program.memory}</legend>
      <div class="segments">
        {all.map((index) => {
          const flies = index === flying;
          const given = givenName(session.origin.named.value, index);
          // The sign alone tells it where the pilot's name has the room.
          const below = given === '' && flies ? nextFlight.badge : given;
          return (
            <label key={index}>
              <input
                type="radio"
                class="visually-hidden"
                name={name}
                aria-label={nameOf(index)}
                checked={index === shown}
                disabled={!isConnected}
                onChange={() => void memories.show(index)}
              />
              <span>
                <span>
                  {memoryName(index)} {flies && <PlaneIcon />}
                </span>
                {below !== '' && (
                  <small key={below} class={given === '' ? 'whole' : ''}>
                    {below}
                  </small>
                )}
              </span>
            </label>
          );
        })}
      </div>
    </fieldset>
  );
}
