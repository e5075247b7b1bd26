import type { SharedSetting } from '../../../program/index.js';
import { messages, timerName } from '../../messages/index.js';
import type { Session } from '../../session/session.js';
import type { Sharing } from './sharing.js';

/** Offers the program on the screen, as it stands there. */
export function offerScreen(session: Session, sharing: Sharing): void {
  const shared = screenOf(session);
  if (shared) sharing.offer(shared);
}

/**
 * The program on the screen as a setting: under the name of the one that it belongs to, else that of timer and memory.
 * Null where there is none, or a field without a value.
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
