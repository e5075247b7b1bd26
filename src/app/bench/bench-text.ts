import type { Identity } from '../../protocol/index.js';
import { messages, slotInSentence } from '../messages/index.js';
import type { Done } from './bench.js';

/** Where the servos stand. @param at the slot; null when it is not known. */
export function standText(identity: Identity, at: number | null): string {
  const { bench: words } = messages.value;
  return at === null ? words.atNone : words.at({ slot: slotInSentence(identity, at) });
}

/** What was done last, and its result. For an acknowledged movement: where the servos have stood since. */
export function doneText(identity: Identity, done: Done | null, at: number | null): string {
  const { bench: words } = messages.value;
  if (!done) return standText(identity, at);
  const { action, certain } = done;
  if (action.kind === 'unlock') return certain ? words.unlocked : words.unlockMaybe;
  if (!certain) return words.moveMaybe;
  return action.kind === 'move' ? standText(identity, at) : words.jumped;
}
