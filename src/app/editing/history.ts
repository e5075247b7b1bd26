/** The steps that can be done to a program and undone. messages/ has the names that a pilot reads. */
export const STEP_CODES = [
  'change',
  'shift',
  'step-servo',
  'paste',
  'fill',
  'revert-all',
  'open',
  'keep-tried',
] as const;

export type StepCode = (typeof STEP_CODES)[number];

/**
 * The name of a step. Its parameters, where it has any:
 * - `field`, the key of a field; or `slot`, counted from 0: what a `change` changed, if not a range
 * - `by`, hundredths of a second; of a servo, steps
 * - `servo`, counted from 0, and `from`, the first slot in which it moves
 * - `count`, how many values it changed
 * - `name`, that of the setting that was opened
 */
export interface StepName {
  readonly code: StepCode;
  readonly params: Readonly<Record<string, string | number>>;
}

/** The present codes of steps that had codes of their own once: stored drafts still have those. */
export const FORMER_STEPS = new Map<string, StepCode>([
  ...[
    'type',
    'step',
    'interval',
    'copy-servo',
    'reverse-servo',
    'revert',
    'revert-row',
    'revert-column',
    'move-mark',
    'preset',
    'fix',
    'take-across',
  ].map((code) => [code, 'change'] as const),
  ...['finish-write', 'restore', 'lay-over', 'load-setting', 'saved-elsewhere'].map((code) => [code, 'open'] as const),
]);

/**
 * A step with the state that it leads back to: the state before it if it can be undone, after it if it can be redone.
 */
interface Step<T> {
  readonly name: StepName;
  readonly state: T;
}

/**
 * Everything that was done and undone. States are whole and immutable. What two states have in common they share, also
 * when structured clone stores them. The present state is not in it. Plain data; after loading see {@link settle}.
 */
export interface History<T> {
  /** Oldest first. */
  readonly past: readonly Step<T>[];
  /** The last one is the next to redo. */
  readonly future: readonly Step<T>[];
  /** The group of the last step, while that step can still grow; null when the next edit is a new step. */
  readonly open: string | null;
}

/** A history, and the state to show with it. */
export interface Turned<T> {
  readonly history: History<T>;
  readonly state: T;
}

/** How many steps can be undone. Older ones are forgotten. */
export const MAX_STEPS = 200;

export const EMPTY_HISTORY: History<never> = { past: [], future: [], open: null };

/** The group of typing in one field, of stepping it, or of one movement of its handle. */
export function groupOf(how: 'type' | 'step' | 'move', field: string): string {
  return `${how} ${field}`;
}

/** Whether a handle is being moved: then the last step grows with each frame. */
export function isMoving({ open }: History<unknown>): boolean {
  return open?.startsWith(groupOf('move', '')) ?? false;
}

/**
 * Adds a step. Steps that could be redone are forgotten.
 * @param before the state before it.
 * @param group steps of one group in a row become one, with the latest name, until {@link settle}: typing in one field,
 * one drag.
 */
export function recordStep<T>(history: History<T>, name: StepName, before: T, group: string | null = null): History<T> {
  const last = history.past.at(-1);
  const grows = group !== null && group === history.open && last !== undefined;
  const step = { name, state: grows ? last.state : before };
  const earlier = grows ? history.past.slice(0, -1) : history.past;
  return { past: [...earlier, step].slice(-MAX_STEPS), future: [], open: group };
}

/**
 * Ends the last step: the field was left, the drag has ended, or the history comes from storage. The next edit is a new
 * step.
 * @param isNow whether a state equals the present one. A last step that came back to where it began is removed.
 */
export function settle<T>(history: History<T>, isNow: (state: T) => boolean = () => false): History<T> {
  const last = history.past.at(-1);
  if (last && isNow(last.state)) return { ...history, past: history.past.slice(0, -1), open: null };
  return history.open === null ? history : { ...history, open: null };
}

/** @returns null when there is nothing to undo. */
export function undo<T>(history: History<T>, now: T): Turned<T> | null {
  return turned(history, now, 'past', 'future');
}

/** @returns null when there is nothing to redo. */
export function redo<T>(history: History<T>, now: T): Turned<T> | null {
  return turned(history, now, 'future', 'past');
}

/** @param now the present state, to which the other way leads back. */
function turned<T>(history: History<T>, now: T, from: 'past' | 'future', to: 'past' | 'future'): Turned<T> | null {
  const step = history[from].at(-1);
  if (!step) return null;
  const back = { name: step.name, state: now };
  const steps = { [from]: history[from].slice(0, -1), [to]: [...history[to], back] };
  return { history: { ...history, ...steps, open: null }, state: step.state };
}

/**
 * Takes back the last step, which is still growing, as if it had never been: Escape in a field or in a drag.
 */
export function abandon<T>({ past, future }: History<T>): Turned<T> | null {
  const step = past.at(-1);
  return step ? { history: { past: past.slice(0, -1), future, open: null }, state: step.state } : null;
}

/**
 * Replaces each state of the history, as after a reading in which the timer holds something else: undo must not bring
 * back what nobody typed.
 */
export function mapStates<T, U>(history: History<T>, map: (state: T) => U): History<U> {
  const mapped = (steps: readonly Step<T>[]): Step<U>[] =>
    steps.map(({ name, state }) => ({ name, state: map(state) }));
  return { past: mapped(history.past), future: mapped(history.future), open: history.open };
}
