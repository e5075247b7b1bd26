import { useComputed } from '@preact/signals';
import { messages } from '../messages/index.js';
import { memoryName } from '../messages/names.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import './next-flight-line.css';

/** What is to be known about the memory that flies next, in every view. What is unfinished has its own band. */
export function NextFlightNotes({ session }: { readonly session: Session }) {
  const { program } = messages.value;
  const { editor, onScreen, nextFlight, runner, connection } = session;
  // So that it is not drawn again with each key.
  const hasProgram = useComputed(() => editor.working.value !== null && editor.madeAt.value === null).value;
  const isOpen = nextFlight.open.value && !runner.busy.value && connection.value !== null;
  return (
    <>
      {hasProgram && onScreen.memory.value === null && <p class="hint next-flight">{program.memoryUnknown}</p>}
      {hasProgram && isOpen && !nextFlight.word.value && <p class="bad-text next-flight">{program.memoryOpen}</p>}
      {!runner.busy.value && connection.value !== null && <Line session={session} />}
    </>
  );
}

/** Another memory that flies next than the one on the screen, or than when the timer came. The pilot has chosen it. */
function Line({ session }: { readonly session: Session }) {
  const { nextFlight: words, look } = messages.value;
  const { nextFlight, onScreen, reader } = session;
  const memory = nextFlight.memory.value;
  const before = nextFlight.chosen.value?.before ?? null;
  const shown = onScreen.apart.value ? onScreen.memory.value : null;
  if (memory === null || (shown === null && !nextFlight.chosen.value)) return null;
  const flies = words.other({ memory: memoryText(session, memory) });
  return (
    <div class="row next-flight">
      <p class="hint" role="status">
        {shown !== null && <strong>{words.onScreen({ memory: memoryText(session, shown) })}</strong>} {flies}{' '}
        {before !== null && words.original({ original: memoryText(session, before) })}
      </p>
      {shown !== null && (
        <button type="button" class="quiet" onClick={() => void showNext(reader)}>
          {look.show({ memory: memoryName(memory) })}
        </button>
      )}
    </div>
  );
}

async function showNext(reader: Session['reader']): Promise<void> {
  if (!(await reader.showNext())) await reader.read(true);
}
