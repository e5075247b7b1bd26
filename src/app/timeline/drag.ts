import { fieldKey, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { MAX_POSITION, MAX_TIME } from '../../protocol/index.js';
import { type Edit, setValues, stepSize } from '../editing/edit.js';
import { onStep } from '../editing/edits.js';
import { groupOf } from '../editing/history.js';
import type { Geometry } from './geometry.js';

/** `moving`: the handle is held. `done`: it was released. `back`: it was released where it began, or put back. */
export type DragPhase = 'moving' | 'done' | 'back';

/** All edits of one movement are of one group, so undo takes them back as one step. */
export type OnEdit = (edit: Edit, phase: DragPhase) => void;

/** The picture as last drawn, and what can be done with it by pointer and by keys. */
export interface Shown {
  readonly svg: SVGSVGElement;
  readonly geometry: Geometry;
  /** Gives the present program. */
  readonly now: () => TimerProgram;
  /** Absent when nothing can be changed. */
  readonly onEdit: OnEdit | undefined;
  /** The place of the scale around which to zoom; undefined for the middle of the view. */
  readonly anchor: () => number | undefined;
}

/**
 * The range in which a field can move. A time stays between its neighbours, at least one step from each; a neighbour
 * that it has reached or passed already does not hold it. The motor stop lies between launch and DT.
 */
export function limitsOf(program: TimerProgram, field: ProgramField): { readonly min: number; readonly max: number } {
  if (field.kind !== 'time') return { min: 0, max: MAX_POSITION };
  const { identity, times } = program;
  const { slot } = field;
  const step = stepSize(identity, field);
  const largest = Math.floor(MAX_TIME / step) * step;
  const time = times[slot] as number;
  const before = slot > 1 ? (times[slot - 1] as number) : 0;
  const after = times[slot === 0 ? identity.functions : slot + 1] ?? MAX_TIME + 1;
  const min = before < time ? Math.ceil((before + 1) / step) * step : before === time ? time : 0;
  const max = after > time ? Math.floor((after - 1) / step) * step : after === time ? time : largest;
  // Close neighbours may leave no whole step between them: then the time stays.
  return { min: Math.min(min, time), max: Math.max(max, time) };
}

/** The nearest value to which a field can move: a whole step within its limits. */
export function snapped(program: TimerProgram, field: ProgramField, value: number): number {
  const step = stepSize(program.identity, field);
  return within(program, field, Math.round(value / step) * step);
}

/** The value some steps up or down, within its limits. */
export function stepped(program: TimerProgram, field: ProgramField, steps: number): number {
  return within(program, field, onStep(stepSize(program.identity, field), valueAt(program, field) ?? 0, steps));
}

function within(program: TimerProgram, field: ProgramField, value: number): number {
  const { min, max } = limitsOf(program, field);
  return Math.min(max, Math.max(min, value));
}

/**
 * One movement of one handle, from taking it to releasing it. It is over as soon as the program holds another value
 * than the movement gave: an undo, or the program of another timer, has come meanwhile.
 */
export class DragEdit {
  /** As it was when the handle was taken. */
  readonly program: TimerProgram;
  readonly field: ProgramField;
  readonly #now: () => TimerProgram;
  readonly #onEdit: OnEdit;
  readonly #original: number;
  #last: number;
  #moved = false;

  /** @param now gives the present program. */
  constructor(now: () => TimerProgram, field: ProgramField, onEdit: OnEdit) {
    this.program = now();
    this.field = field;
    this.#now = now;
    this.#onEdit = onEdit;
    this.#original = this.#last = valueAt(this.program, field) ?? 0;
  }

  /** The present value of the handle. */
  get value(): number {
    return this.#last;
  }

  move(value: number): void {
    if (value === this.#last || this.#isOver) return;
    this.#last = value;
    this.#moved = true;
    this.#tell('moving');
  }

  /** The handle is released. A movement that changed nothing is not reported. @param isMeant else puts it back. */
  end(isMeant: boolean): void {
    if (!this.#moved || this.#isOver) return;
    if (!isMeant) this.#last = this.#original;
    this.#tell(this.#last === this.#original ? 'back' : 'done');
  }

  get #isOver(): boolean {
    return (valueAt(this.#now(), this.field) ?? 0) !== this.#last;
  }

  #tell(phase: DragPhase): void {
    const { field } = this;
    const key = fieldKey(field);
    const name = { code: 'change', params: { field: key } } as const;
    this.#onEdit(setValues(name, [{ field, value: this.#last }], groupOf('move', key)), phase);
  }
}
