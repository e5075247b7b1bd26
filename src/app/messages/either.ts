import { apart } from './apart.js';
import { moreMessages } from './more.js';

/** How many models one sentence names. The list of models has all of them. */
const NAMED = 6;

/** A choice in one phrase: “Lancer, Vega or 3 more”. */
export function eitherOf(names: readonly string[]): string {
  const { or, others } = moreMessages.value.whichModel;
  const own = names.map(apart);
  const rest = names.length - NAMED + 1;
  const all = rest < 2 ? own : [...own.slice(0, NAMED - 1), others({ count: rest })];
  const [last = ''] = all.splice(-1);
  return all.length === 0 ? last : or({ names: all.join(', '), last });
}
