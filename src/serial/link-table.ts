/**
 * Where a link to a timer may stand, and where each event leads from there. What is not listed cannot happen there.
 *
 * States:
 * - `off`: nothing is open.
 * - `choosing`: the browser's chooser is shown.
 * - `opening`: a port is being opened; as long as it is refused, again and again for a while.
 * - `searching`: the port is open, and one rate after another is tried.
 * - `waiting`: nothing answered at any rate; it is asked quietly until something does.
 * - `on`: a timer has said what it is.
 * - `away`: the port was unplugged or its stream failed; it is opened again once it is there.
 * - `closing`: the last request comes to its end and the port is closed.
 *
 * Events:
 * - `choose`, `open`, `stop`: asked for by {@link TimerLink}'s methods.
 * - `refused`: the port is there and does not open: most often another program has it, perhaps only for a moment.
 * - `opened`: the port is open.
 * - `asked`: a rate is being tried, or was tried in vain.
 * - `answered`: the timer has said what it is.
 * - `silent`: nothing answers, or no longer.
 * - `another`: a timer answers, and it is not the one that was there.
 * - `lost`: the port is gone or its stream has failed.
 * - `unplugged`: a port whose stream has failed turns out to be unplugged.
 * - `returned`: the port is there again.
 * - `closed`: the port is closed.
 * - `failed`: it ends here, for the reason that comes with it.
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

export type LinkStatus = keyof typeof LINK_TABLE;

export type LinkEvent = { [Status in LinkStatus]: keyof (typeof LINK_TABLE)[Status] }[LinkStatus];

/**
 * Where an event leads.
 * @throws Error when it cannot happen there: a mistake of the program.
 */
export function nextStatus(status: LinkStatus, event: LinkEvent): LinkStatus {
  const next = (LINK_TABLE[status] as Partial<Record<LinkEvent, LinkStatus>>)[event];
  if (!next) throw new Error(`a link that is ${status} knows no event ${event}`);
  return next;
}
