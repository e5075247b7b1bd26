import { useComputed } from '@preact/signals';
import { messages } from '../messages/index.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import './next-flight-line.css';

/** What is to be known about the memory that flies next, in every view. What is unfinished has its own band. */
export function NextFlightNotes({ session }: { readonly session: Session }) {
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
      <ChosenLine session={session} />
    </>
  );
}

/** The memory that the pilot has chosen: no warning. */
function ChosenLine({ session }: { readonly session: Session }) {
  const { nextFlight: words } = messages.value;
  const chosen = session.nextFlight.chosen.value;
  if (!chosen || session.connection.value === null || session.runner.busy.value) return null;
  const { memory, before } = chosen;
  return (
    <p class="hint next-flight" role="status">
      {words.other(memoryText(session, memory))} {before !== null && words.original(memoryText(session, before))}
    </p>
  );
}
