import type { SharedSetting } from '../../../program/index.js';
import { memoryName, timerName } from '../../messages/names.js';
import type { Session } from '../../work/session.js';
import { programName } from '../../work/standing-text.js';
import type { Sharing } from './sharing.js';

/** Offers the program on the screen, edits included. */
export function offerScreen(session: Pick<Session, 'opened' | 'origin'>, sharing: Sharing): void {
  const shared = screenOf(session);
  if (shared) sharing.offer(shared);
}

/**
 * The program on the screen as a setting, under the name of its own setting, or else of timer and memory. Null when
 * there is no program, or a field has no value.
 */
function screenOf({ opened, origin }: Pick<Session, 'opened' | 'origin'>): SharedSetting | null {
  const program = origin.program.value;
  if (!program || !opened.savable.value) return null;
  const { identity, memory } = program;
  const setting = origin.setting.value;
  const title = programName({ origin, opened });
  const own = [timerName(identity), ...(memory === null ? [] : [memoryName(memory)])].join(' ');
  return {
    name: title || own,
    note: setting?.note ?? '',
    tags: setting?.tags ?? [],
    at: Date.now(),
    program,
    modelName: origin.model.value?.name ?? '',
  };
}
