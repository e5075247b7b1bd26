import type { LineEntry } from '../../client/index.js';
import { COMMANDS, decodeReply, type Identity, type LayoutOptions, type LayoutQuirks } from '../../protocol/index.js';

/** One entry of the line, as the log keeps it. */
export interface LineRecord extends LineEntry {
  /** Counts from 1. Never used again, not even after the log is cleared. */
  readonly number: number;
  /** What was known about the timer at that time, which decides how its messages are read. */
  readonly layout: LayoutOptions;
}

/**
 * Gives each entry its number, and what is known about the timer at that time: its last identity.
 * @param quirks gives what is assumed about the timer now.
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

/** Whether the timer gives its identity in it. */
export function isReplyToIdentify({ direction, frame }: LineEntry): boolean {
  return direction === 'in' && frame?.code === COMMANDS.GETSWVER.reply;
}

/** The identity of the timer in it; undefined when no timer can have it. */
function identityIn({ frame }: LineEntry): Identity | undefined {
  try {
    const reply = frame && decodeReply(frame);
    return reply?.name === 'GETSWVER' ? reply.identity : undefined;
  } catch {
    return undefined;
  }
}
