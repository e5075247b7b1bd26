import type { Heard, LinkState } from '../../serial/index.js';
import { hexOf } from '../messages/hex.js';
import { messages, readable, type Said } from '../messages/index.js';
import type { HelpCode } from './connection-help.js';

/** How long a port may take to open, in seconds. A Bluetooth port takes some. */
const OPENS = 5;
/** How long a timer that is awake may take, in seconds. Until then the pilot has nothing to do. */
const AWAKE = 2;
/** From this many seconds on, the page asks to check the distance; later, whether this is the right adapter. */
const NEAR = 10;
const OTHER = 30;

/** What the pilot can do while the link asks for a timer, one after the other. */
export const WAIT_STEPS = ['switch', 'near', 'other'] as const;
type WaitStep = (typeof WAIT_STEPS)[number];

/** What the page says while connecting. */
export interface Waiting {
  readonly said: Said;
  /** What changes with the seconds or the bytes: shown beside it, and not announced. */
  readonly now: string;
  /** The step to take now; null for none. */
  readonly step: WaitStep | null;
  /** Whether the pilot can choose another port while the link asks at this one. */
  readonly canChoose: boolean;
  /** What there is more help for; null for nothing. */
  readonly help: HelpCode | null;
}

/** Nothing for the pilot to do. */
export const NOTHING = { now: '', step: null, canChoose: false, help: null };

/**
 * What to say while connecting; null once that has ended, well or not.
 * @param seconds since the port was opened, or since the first question to the timer.
 */
export function waitingFor(state: LinkState, seconds: number): Waiting | null {
  const { connection, link } = messages.value;
  switch (state.status) {
    case 'choosing':
      return { ...NOTHING, said: titled(link.stages.choosing) };
    case 'opening':
      if (state.refusals > 0)
        return { ...NOTHING, said: { title: connection.busy.title, advice: link.refused }, help: 'busy' };
      if (seconds < OPENS) return { ...NOTHING, said: titled(link.status.opening) };
      return { ...NOTHING, said: link.stages.openingLong, canChoose: true };
    case 'searching':
    case 'waiting': {
      const heard = state.status === 'waiting' ? state.heard : null;
      if (heard) return { ...heardSaid(heard), step: null, canChoose: true, help: 'waiting' };
      if (seconds < AWAKE && state.status === 'searching')
        return { ...NOTHING, said: titled(link.status.searching), now: link.stages.asking({ rate: state.baudRate }) };
      const step = seconds < NEAR ? 'switch' : seconds < OTHER ? 'near' : 'other';
      const said = titled(link.stages.steps[step]);
      const now = link.stages.noAnswer({ seconds });
      return { said, now, step, canChoose: true, help: seconds < NEAR ? null : 'waiting' };
    }
    case 'away':
      return { ...NOTHING, said: link.lost, help: 'lost' };
    case 'closing':
      return { ...NOTHING, said: titled(link.status.closing) };
    default:
      return null;
  }
}

/** What is happening, with nothing to add. */
export function titled(title: string): Said {
  return { title, advice: '' };
}

/** How many of the last bytes are shown. */
const SHOWN = 20;

function heardSaid({ kind, sample, baudRate }: Heard): Pick<Waiting, 'said' | 'now'> {
  const { heard, itSaid, slow } = messages.value.link;
  if (kind === 'slow') return { said: { title: slow.title, advice: slow.advice({ rate: baudRate }) }, now: '' };
  const last = sample.slice(-SHOWN);
  return { said: heard, now: last.length === 0 ? '' : itSaid({ bytes: hexOf(last), text: readable(last) }) };
}
