import { plural } from './plural.js';

/** The content of a timeline, for one sentence. */
export interface TimelineFacts {
  readonly servos: number;
  readonly functions: number;
  readonly dt: string;
  readonly motorStop: string | null;
}

/** The picture of a program over time. */
export const timeline = {
  title: 'Timeline',
  /** While it is open whether the tried positions stay: what the timer held before them. */
  compareBefore: 'before following',
  picture: 'Servo positions over time',
  description: ({ servos, functions, dt, motorStop }: TimelineFacts) =>
    `${plural(servos, 'servo', 'servos')} and ${plural(functions, 'function', 'functions')} over time, DT at ${dt}${motorStop === null ? '' : `, motor stop at ${motorStop}`}. The table has all values.`,
  keysToEdit:
    'Arrows go from mark to mark and from servo to servo, plus and minus zoom, 0 shows all. Enter goes to the handles: arrows move them, Escape comes back.',
  ask: 'Point or tap to read',
  /** While a handle is moved: the further away the pointer is, the finer. */
  finer: 'Finer',
  steps: (position: number) => plural(position, 'step', 'steps'),
  stepsUnit: 'steps',
  notKnown: 'Not known: the times fall',
  tools: 'View',
  zoomIn: 'Zoom in',
  zoomOut: 'Zoom out',
  fit: 'Show all',
  passedOver: (slot: string, next: string) => `${slot} is skipped: ${next} comes at the same time.`,
  goesBack: (next: string, slot: string) =>
    `${next} comes before ${slot}. It is not known what the timer does in the shaded part.`,
};
