import { messages } from '../messages/index.js';
import type { NextFlightWord } from '../timer/next-flight.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';

/**
 * Says that another memory than the one that is meant flies next, or that nobody knows which.
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
