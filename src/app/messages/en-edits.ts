import type { FindingCode } from '../../program/index.js';
import type { RefusalCode } from '../state/edits.js';
import type { StepCode } from '../state/history.js';
import type { PasteProblemCode } from '../state/paste.js';
import type { UnreadableReason } from '../units.js';

type Params = Readonly<Record<string, string>>;

/** What a step is called after “Undo” and “Redo”. */
const steps: Record<StepCode, (params: Params) => string> = {
  type: ({ field }) => `typing in ${field}`,
  step: ({ field }) => `stepping of ${field}`,
  shift: ({ column, by }) => `shift from ${column} by ${by}`,
  interval: ({ column }) => `interval of ${column}`,
  paste: ({ count }) => `paste of ${count}`,
  fill: ({ count }) => `fill down of ${count}`,
  'copy-servo': ({ from, to }) => `copy of ${from} to ${to}`,
  'reverse-servo': ({ servo }) => `reversal of ${servo}`,
  revert: ({ field }) => `putting back ${field}`,
  'revert-row': ({ column }) => `putting back ${column}`,
  'revert-column': ({ name }) => `putting back ${name}`,
  'revert-all': () => 'putting back everything',
  'move-mark': ({ field }) => `moving ${field}`,
  preset: ({ field }) => `preset of ${field}`,
  'finish-write': () => 'taking up the interrupted write',
  restore: () => 'taking over a backup',
  fix: ({ field }) => `correction of ${field}`,
};

/** What stands in the way of an edit or of a pasted cell, beyond what the checks and the fields say themselves. */
const refused: Record<
  Exclude<RefusalCode | PasteProblemCode, FindingCode | UnreadableReason>,
  (params: Params) => string
> = {
  reserved: () => 'The reserved time is changed only in its own field.',
  'no-interval': () => 'The start follows nothing, so it has no interval.',
  'later-out-of-range': ({ min, max }) => `This interval would move a later function out of ${min} to ${max}.`,
  'interval-disagrees': () => 'This is not the interval between the times of the two rows.',
  'too-large': ({ cells }) => `The table is too large: the rest was not read. At most ${cells} cells are.`,
};

/** Undo, redo, and edits of many fields at once. */
export const edits = {
  undo: (step: string) => `Undo ${step}`,
  redo: (step: string) => `Redo ${step}`,
  steps,
  refused,
};
