import type { SharedSetting } from '../../../program/index.js';
import { messages, timerName } from '../../messages/index.js';
import type { Session } from '../../session/session.js';
import type { Sharing } from './sharing.js';

/** Offers the program on the screen, edits included. */
export function offerScreen(session: Session, sharing: Sharing): void {
  const shared = screenOf(session);
  if (shared) sharing.offer(shared);
}

/**
 * The program on the screen as a setting, under the name of its own setting, or else of timer and memory. Null when
 * there is no program, or a field has no value.
 */
function screenOf({ editor, opened, modelAtHand }: Session): SharedSetting | null {
  const program = editor.working.value;
  if (!program || !opened.savable.value) return null;
  const { identity, memory } = program;
  const { memoryName } = messages.value;
  const setting = opened.shown.value?.setting;
  const own = [timerName(identity), ...(memory === null ? [] : [memoryName(memory)])].join(' ');
  return {
    name: setting?.name ?? own,
    note: setting?.note ?? '',
    tags: setting?.tags ?? [],
    at: Date.now(),
    program,
    modelName: modelAtHand.value?.name ?? '',
  };
}
