import type { TimerProgram } from '../../program/index.js';
import { libraryMessages } from '../messages/en-library.js';
import { timerName } from '../messages/index.js';

/** The timer that a program is for. A program that was made here has no firmware. */
export function timerText({ identity }: TimerProgram): string {
  const firmware = identity.firmware === '000' ? null : identity.firmware;
  return libraryMessages.setting.timer(timerName(identity), firmware, identity.functions - 1, identity.servos);
}
