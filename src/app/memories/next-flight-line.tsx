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

/** Says that another memory than at connect flies next, or that nobody knows which; with a button to go back. */
function NextFlightLine({ session, memories }: NextFlightProps) {
  const { nextFlight: words } = messages.value;
  const word = session.nextFlight.word.value;
  const isConnected = session.connection.value !== null;
  // During a job over memories there is nothing to say yet. An interrupted job has its own message.
  if (!word || session.runner.busy.value || session.recovery.offer.value?.kind === 'memories') return null;
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

/**
 * The same as a sentence.
 * @param when `now`: what the timer says. `will`: what will follow. `last`: what it said before the connection was
 * lost.
 */
export function nextFlightText(session: Session, word: NextFlightWord, when: 'now' | 'will' | 'last'): string {
  const { nextFlight: words } = messages.value;
  const nameOf = (memory: number): string => memoryText(session, memory);
  const said =
    word.code === 'other'
      ? [{ now: words.other, will: words.will, last: words.last }[when](nameOf(word.memory))]
      : [words.unknown, ...(word.asked === null ? [] : [words.asked(nameOf(word.asked))])];
  const original = word.original === null ? words.originalUnknown : words.original(nameOf(word.original));
  return [...said, original].join(' ');
}
