import type { LineEntry } from '../../client/index.js';
import { COMMANDS, decodeReply, type Identity, type LayoutOptions, type LayoutQuirks } from '../../protocol/index.js';

/** One thing on the line, as it is kept. */
export interface LineRecord extends LineEntry {
  /** Counts from 1 and is never used again, not even after clearing. */
  readonly number: number;
  /** What was known of the timer by then: how its messages are to be read. */
  readonly layout: LayoutOptions;
}

/**
 * Gives each entry its number and what is known of the timer by then: what it last said of itself.
 * @param quirks what is assumed of the timer now.
 */
export function recorder(quirks: () => LayoutQuirks = () => ({})): (entry: LineEntry) => LineRecord {
  let number = 0;
  let identity: Identity | undefined;
  return (entry) => {
    if (isReplyToIdentify(entry)) identity = identityIn(entry);
    number++;
    return { ...entry, number, layout: { identity, quirks: quirks() } };
  };
}

/** Whether the timer says in it what it is. */
export function isReplyToIdentify({ direction, frame }: LineEntry): boolean {
  return direction === 'in' && frame?.code === COMMANDS.GETSWVER.reply;
}

/** What the timer says of itself; undefined when that cannot be. */
function identityIn({ frame }: LineEntry): Identity | undefined {
  try {
    const reply = frame && decodeReply(frame);
    return reply?.name === 'GETSWVER' ? reply.identity : undefined;
  } catch {
    return undefined;
  }
}
