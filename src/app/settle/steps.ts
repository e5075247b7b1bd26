import type { Said, Seen } from './conclusions.js';

/** What a step does on the wire when the person presses its button. */
export type Act = 'read' | 'try' | 'zeros' | 'unlock';

/** One step of the walk. */
export interface Step {
  readonly name: 'read' | 'times' | 'count' | 'memory' | 'away' | 'there' | 'zeros' | 'unlock' | 'end';
  readonly act?: Act;
  /** What may move when its button is pressed: that is said at the button. */
  readonly moves?: 'servos' | 'motor';
  /** The question to the person, after the act. */
  readonly asks?: keyof Said;
  /** Whether it tells something of this timer, after the reading. Default: always. */
  readonly isFor?: (seen: Seen) => boolean;
}

const hasCell = ({ identity }: Seen): boolean => identity.functions > 1;

/** The steps in their order: first what only reads, then what may move a servo, at last the motor. */
export const STEPS: readonly Step[] = [
  { name: 'read', act: 'read' },
  { name: 'times', asks: 'times' },
  { name: 'count', asks: 'count' },
  { name: 'memory', asks: 'memory', isFor: ({ indices }) => indices.some((index) => index !== null) },
  { name: 'zeros', act: 'zeros' },
  { name: 'away', act: 'try', moves: 'servos', asks: 'away', isFor: hasCell },
  { name: 'there', act: 'try', moves: 'servos', asks: 'there', isFor: hasCell },
  { name: 'unlock', act: 'unlock', moves: 'motor', isFor: ({ identity }) => identity.timerClass === 'Q' },
  { name: 'end' },
];
