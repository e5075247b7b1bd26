import type { Heard, LinkState } from '../../serial/index.js';
import { messages, readable, type Said } from '../messages/index.js';
import type { HelpCode } from './connection-help.js';

/** So long a timer that is awake may take, in seconds: until then there is nothing for the pilot to do. */
const AWAKE = 2;
/** From then on its distance is the next thing to look at, and from then on whether this is its adapter. */
const NEAR = 10;
const OTHER = 30;

/** What the pilot can do while a timer is asked, one after the other. */
export const WAIT_STEPS = ['switch', 'near', 'other'] as const;
export type WaitStep = (typeof WAIT_STEPS)[number];

/** What is said while a timer is on its way. */
export interface Waiting {
  readonly said: Said;
  /** Which step is to be taken now; null where there is none. */
  readonly step: WaitStep | null;
  /** Whether another port can be chosen while this one is asked. */
  readonly canChoose: boolean;
  /** What there is more help for. */
  readonly help: HelpCode | null;
}

const NOTHING = { step: null, canChoose: false, help: null };

/**
 * What to say of a way to a timer; null where it has ended, well or not.
 * @param seconds since the timer was asked first.
 */
export function waitingFor(state: LinkState, seconds: number): Waiting | null {
  const { link } = messages.value;
  switch (state.status) {
    case 'choosing':
      return { ...NOTHING, said: link.stages.choosing };
    case 'opening':
      return state.refusals === 0
        ? { ...NOTHING, said: link.stages.opening }
        : { ...NOTHING, said: link.refused, help: 'busy' };
    case 'searching':
    case 'waiting': {
      const heard = state.status === 'waiting' ? state.heard : null;
      if (heard) return { said: heardSaid(heard), step: null, canChoose: true, help: 'waiting' };
      if (seconds < AWAKE && state.status === 'searching')
        return { ...NOTHING, said: link.stages.looking(state.baudRate) };
      const step = seconds < NEAR ? 'switch' : seconds < OTHER ? 'near' : 'other';
      const said = { title: link.stages.steps[step].now, advice: link.stages.silent };
      return { said, step, canChoose: true, help: seconds < NEAR ? null : 'waiting' };
    }
    case 'away':
      return { ...NOTHING, said: state.unplugged ? link.away : link.brokenOff, help: 'lost' };
    case 'closing':
      return { ...NOTHING, said: link.stages.closing };
    default:
      return null;
  }
}

/** Characters of a line of text that are shown. */
const LINE = 40;

/** Of text the last line that came whole, as far as it is short. */
function heardSaid({ kind, sample, baudRate }: Heard): Said {
  const lines = readable(sample).split(/·+/);
  const line = lines.at(-2) || lines.at(-1) || '';
  return messages.value.link.heard[kind](line.trim().slice(-LINE), baudRate);
}
