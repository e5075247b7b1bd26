import { useComputed } from '@preact/signals';
import { messages } from '../messages/index.js';
import { memoryText } from '../session/memory-names.js';
import type { NextFlightWord } from '../session/next-flight.js';
import type { Session } from '../session/session.js';
import type { Memories } from './memories.js';
import './next-flight-line.css';

interface NextFlightProps {
  readonly session: Session;
  readonly memories: Memories;
}

/** What is unusual about the memory that flies next, in every view. */
export function NextFlightNotes({ session, memories }: NextFlightProps) {
  const { program } = messages.value;
  const { editor, nextFlight, runner, connection } = session;
  // So that it is not drawn again with each key.
  const hasProgram = useComputed(() => editor.working.value !== null && editor.madeAt.value === null).value;
  const memory = useComputed(() => editor.working.value?.memory ?? null).value;
  const isOpen = nextFlight.open.value && !runner.busy.value && connection.value !== null;
  return (
    <>
      {hasProgram && memory === null && <p class="hint next-flight">{program.memoryUnknown}</p>}
      {hasProgram && isOpen && !nextFlight.word.value && <p class="bad-text next-flight">{program.memoryOpen}</p>}
      <NextFlightLine session={session} memories={memories} />
    </>
  );
}

/**
 * Says that another memory than the one that is meant flies next, or that nobody knows which, with a button to go back.
 * The pilot's own choice is said calmly.
 */
function NextFlightLine({ session, memories }: NextFlightProps) {
  const { nextFlight: words } = messages.value;
  const word = session.nextFlight.word.value;
  const isConnected = session.connection.value !== null;
  // During a job over memories there is nothing to say yet. An interrupted job has its own message.
  if (session.runner.busy.value || session.recovery.offer.value?.kind === 'memories') return null;
  if (!word) return <ChosenLine session={session} />;
  const { original } = word;
  return (
    <div class="notice bad next-flight" role="alert">
      <p>
        <strong>{nextFlightText(session, word, isConnected ? 'now' : 'last')}</strong>
      </p>
      {original !== null && isConnected && (
        <button type="button" onClick={() => void memories.fly(original)}>
          {words.back(memoryText(session, original))}
        </button>
      )}
    </div>
  );
}

function ChosenLine({ session }: { readonly session: Session }) {
  const { nextFlight: words } = messages.value;
  const chosen = session.nextFlight.chosen.value;
  if (!chosen || session.connection.value === null) return null;
  const { memory, before } = chosen;
  return (
    <p class="hint next-flight" role="status">
      {words.other(memoryText(session, memory))} {before !== null && words.original(memoryText(session, before))}
    </p>
  );
}

/**
 * The same as a sentence.
 * @param when `now`: what the timer says. `last`: what it said before the connection was lost.
 */
export function nextFlightText(session: Session, word: NextFlightWord, when: 'now' | 'last'): string {
  const { nextFlight: words } = messages.value;
  const nameOf = (memory: number): string => memoryText(session, memory);
  const said =
    word.code === 'other'
      ? [{ now: words.other, last: words.last }[when](nameOf(word.memory))]
      : [words.unknown, ...(word.asked === null ? [] : [words.asked(nameOf(word.asked))])];
  const came = session.nextFlight.came.value;
  return [...said, came === null ? words.originalUnknown : words.original(nameOf(came))].join(' ');
}
