import type { TimerProgram } from '../../program/index.js';
import { replaceAll } from '../editing/edit.js';
import type { Session } from '../work/session.js';
import type { WriteJob } from '../write/write-job.js';

type Parts = Pick<Session, 'recovery' | 'editor'>;

/**
 * What the pilot can do after an interrupted write: write the values that are still missing (`goal`), or put back the
 * values from before. Shows the difference first, like any other write.
 */
export async function finishWrite(session: Parts, write: WriteJob, end: 'goal' | 'before'): Promise<void> {
  const program = programOf(session, end);
  if (!program) return;
  session.editor.apply(replaceAll({ code: 'open', params: {} }, program));
  await write.open();
}

/** Shows the goal of the interrupted write as edits, and forgets the write. */
export async function takeGoal(session: Parts): Promise<void> {
  const goal = programOf(session, 'goal');
  if (!goal) return;
  session.editor.apply(replaceAll({ code: 'open', params: {} }, goal));
  await session.recovery.settle();
}

/** An unknown idle throttle stays as the timer holds it. */
function programOf({ recovery, editor }: Parts, end: 'goal' | 'before'): TimerProgram | null {
  const offer = recovery.offer.value;
  const held = editor.baseline.value;
  if (offer?.kind !== 'write' || !held) return null;
  const program = offer.record[end];
  return { ...program, idleThrottle: program.idleThrottle ?? held.idleThrottle };
}
