/**
 * The states of a link to a timer, and where each event leads from there. An event that is not listed in a state cannot
 * happen in it.
 * States:
 * - `off`: nothing is open.
 * - `choosing`: the browser's chooser is open.
 * - `opening`: a port is being opened. While it refuses, the link tries again each second, for 15 seconds.
 * - `searching`: the port is open, and the link tries one rate after another.
 * - `waiting`: nothing answered at any rate. The link asks once a second until something does.
 * - `on`: a timer has said what it is.
 * - `away`: the port was unplugged or its stream failed. The link opens it again once it is back.
 * - `closing`: the last request comes to its end, and the port is closed.
 *
 * Events:
 * - `choose`, `open`, `stop`: a caller asked for it, see {@link TimerLink}.
 * - `refused`: the port is there but does not open. Most often another program has it, perhaps only for a moment.
 * - `opened`: the port is open.
 * - `asked`: a rate is being tried, or was tried without an answer.
 * - `answered`: the timer has said what it is.
 * - `silent`: nothing answers, or nothing answers any more.
 * - `another`: another timer than before answers.
 * - `lost`: the port is gone or its stream has failed.
 * - `unplugged`: a port whose stream has failed turns out to be unplugged.
 * - `returned`: the port is back.
 * - `closed`: the port is closed.
 * - `failed`: the link ends here; its error says why.
 */
export const LINK_TABLE = {
  off: { choose: 'choosing', open: 'opening', failed: 'off' },
  choosing: { open: 'opening', stop: 'off', failed: 'off' },
  opening: { refused: 'opening', opened: 'searching', lost: 'away', stop: 'closing', failed: 'off' },
  searching: {
    asked: 'searching',
    answered: 'on',
    silent: 'waiting',
    refused: 'opening',
    lost: 'away',
    stop: 'closing',
    failed: 'off',
  },
  waiting: {
    asked: 'waiting',
    answered: 'on',
    refused: 'opening',
    lost: 'away',
    stop: 'closing',
    failed: 'off',
  },
  on: { silent: 'waiting', another: 'searching', lost: 'away', stop: 'closing' },
  away: { unplugged: 'away', returned: 'opening', stop: 'closing', failed: 'off' },
  closing: { open: 'opening', closed: 'off' },
} as const satisfies Readonly<Record<string, Readonly<Record<string, string>>>>;

/** A state of a link, see {@link LINK_TABLE}. */
export type LinkStatus = keyof typeof LINK_TABLE;

/** What leads a link from one state to another, see {@link LINK_TABLE}. */
export type LinkEvent = { [Status in LinkStatus]: keyof (typeof LINK_TABLE)[Status] }[LinkStatus];

/**
 * The status to which an event leads.
 * @throws Error when the event cannot happen in this status, which is a fault of the program.
 */
export function nextStatus(status: LinkStatus, event: LinkEvent): LinkStatus {
  const next = (LINK_TABLE[status] as Partial<Record<LinkEvent, LinkStatus>>)[event];
  if (!next) throw new Error(`a link that is ${status} knows no event ${event}`);
  return next;
}
