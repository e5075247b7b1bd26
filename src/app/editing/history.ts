/** What can be done to a program in one step that can be undone. The names that a pilot reads stand in messages/. */
export const STEP_CODES = [
  'type',
  'step',
  'shift',
  'interval',
  'paste',
  'fill',
  'copy-servo',
  'reverse-servo',
  'revert',
  'revert-row',
  'revert-column',
  'revert-all',
  'move-mark',
  'preset',
  'finish-write',
  'restore',
  'lay-over',
  'load-setting',
  'saved-elsewhere',
  'fix',
  'keep-tried',
  'take-across',
] as const;

export type StepCode = (typeof STEP_CODES)[number];

/**
 * What a step is called. Parameters, where a step has any: `field`, the key of a field; `slot`, `servo`, `from` and
 * `to`, counted from 0;
 * `by`, hundredths of a second; `count`, how many values it changed.
 */
export interface StepName {
  readonly code: StepCode;
  readonly params: Readonly<Record<string, string | number>>;
}

/**
 * A step, and the state on the far side of it: before it for one that can be undone, after it for one that can be
 * redone.
 */
export interface Step<T> {
  readonly name: StepName;
  readonly state: T;
}

/**
 * What was done, to be undone and redone. States are immutable and whole: what two of them have in common they share,
 * also when they are stored by structured clone. The present state is not in it. Plain data; after it was stored, see
 * {@link settle}.
 */
export interface History<T> {
  /** Oldest first. */
  readonly past: readonly Step<T>[];
  /** The next one to redo last. */
  readonly future: readonly Step<T>[];
  /** The group that the last step belongs to while it can still grow; null when the next step is one of its own. */
  readonly open: string | null;
}

/** A history, and the state to show. */
export interface Turned<T> {
  readonly history: History<T>;
  readonly state: T;
}

/** So many steps can be undone; older ones are forgotten. */
export const MAX_STEPS = 200;

export const EMPTY_HISTORY: History<never> = { past: [], future: [], open: null };

/** The group of what is typed in one field, that of the steps in it, and that of one movement of its handle. */
export function groupOf(how: 'type' | 'step' | 'move', field: string): string {
  return `${how} ${field}`;
}

/** Whether a handle is being moved: the last step grows with each frame. */
export function isMoving({ open }: History<unknown>): boolean {
  return open?.startsWith(groupOf('move', '')) ?? false;
}

/**
 * Something was done. What could be redone is forgotten.
 * @param before the state before it.
 * @param group steps of one group that follow each other become one, until {@link settle}: typing in one field, one
 * drag. The step then has the name that it was given last.
 */
export function recordStep<T>(history: History<T>, name: StepName, before: T, group: string | null = null): History<T> {
  const last = history.past.at(-1);
  const grows = group !== null && group === history.open && last !== undefined;
  const step = { name, state: grows ? last.state : before };
  const earlier = grows ? history.past.slice(0, -1) : history.past;
  return { past: [...earlier, step].slice(-MAX_STEPS), future: [], open: group };
}

/**
 * The field was left, the drag has ended, the history comes from storage: what follows is a step of its own.
 * @param isNow whether a state is like the present one: a last step that has come back to where it began was none.
 */
export function settle<T>(history: History<T>, isNow: (state: T) => boolean = () => false): History<T> {
  const last = history.past.at(-1);
  if (last && isNow(last.state)) return { ...history, past: history.past.slice(0, -1), open: null };
  return history.open === null ? history : { ...history, open: null };
}

/**
 * @param now the present state, to come back to by {@link redo}.
 * @returns null when there is nothing to undo.
 */
export function undo<T>({ past, future }: History<T>, now: T): Turned<T> | null {
  const step = past.at(-1);
  if (!step) return null;
  const undone = { name: step.name, state: now };
  return { history: { past: past.slice(0, -1), future: [...future, undone], open: null }, state: step.state };
}

/**
 * @param now the present state, to come back to by {@link undo}.
 * @returns null when there is nothing to redo.
 */
export function redo<T>({ past, future }: History<T>, now: T): Turned<T> | null {
  const step = future.at(-1);
  if (!step) return null;
  const redone = { name: step.name, state: now };
  return { history: { past: [...past, redone], future: future.slice(0, -1), open: null }, state: step.state };
}

/**
 * Takes the step back that is still growing, as Escape does in a field or in a drag: it will not have been.
 * @returns null when none is.
 */
export function abandon<T>({ past, future, open }: History<T>): Turned<T> | null {
  const step = past.at(-1);
  return open === null || !step
    ? null
    : { history: { past: past.slice(0, -1), future, open: null }, state: step.state };
}

/**
 * The history with each of its states replaced, as when a timer was read that holds something else by now: undo must
 * not bring back what nobody typed.
 */
export function mapStates<T, U>(history: History<T>, map: (state: T) => U): History<U> {
  const mapped = (steps: readonly Step<T>[]): Step<U>[] =>
    steps.map(({ name, state }) => ({ name, state: map(state) }));
  return { past: mapped(history.past), future: mapped(history.future), open: history.open };
}
