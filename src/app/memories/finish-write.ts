import type { TimerProgram } from '../../program/index.js';
import { replaceAll } from '../editing/edit.js';
import { editMemory } from '../write/edit-memory.js';
import type { WriteJob } from '../write/write-job.js';

type Parts = Parameters<typeof editMemory>[0];

/**
 * What the pilot can do after an interrupted write: write the values that are still missing (`goal`), or put back the
 * values from before. Shows the difference first, like any other write.
 */
export async function finishWrite(session: Parts, write: WriteJob, end: 'goal' | 'before'): Promise<void> {
  const program = await programOf(session, end);
  if (!program) return;
  session.editor.apply(replaceAll({ code: 'open', params: {} }, program));
  await write.open();
}

/** Shows the goal of the interrupted write as edits, and forgets the write. */
export async function takeGoal(session: Parts): Promise<void> {
  const goal = await programOf(session, 'goal');
  if (!goal) return;
  session.editor.apply(replaceAll({ code: 'open', params: {} }, goal));
  await session.recovery.settle();
}

/** Values of a memory need that memory on the screen. An unknown idle throttle stays as the timer holds it. */
async function programOf(session: Parts, end: 'goal' | 'before'): Promise<TimerProgram | null> {
  const { recovery, editor, onScreen } = session;
  const found = recovery.offer.value;
  const of = found?.kind === 'write' ? found.read.memory : null;
  if (of !== null && of !== onScreen.memory.value && !(await editMemory(session, of))) return null;
  const offer = recovery.offer.value;
  const held = editor.baseline.value;
  if (offer?.kind !== 'write' || !held) return null;
  const program = offer.record[end];
  return { ...program, idleThrottle: program.idleThrottle ?? held.idleThrottle };
}
