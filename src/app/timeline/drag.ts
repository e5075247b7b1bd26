import { fieldKey, manualRange, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { type Identity, MAX_POSITION, MAX_TIME } from '../../protocol/index.js';
import { type Edit, setValues } from '../editing/edit.js';
import { groupOf, type StepName } from '../editing/history.js';

/** A handle is in hand; it was let go; it was let go where it was taken, as if nothing had been done. */
export type DragPhase = 'moving' | 'done' | 'back';

/** All edits of one movement are of one group: one step for who wants to undo it. */
export type OnEdit = (edit: Edit, phase: DragPhase) => void;

export interface Limits {
  readonly min: number;
  readonly max: number;
}

/** The step of a time of this class in hundredths of a second: 1 where the manual gives none. */
export function timeStep(identity: Identity, slot: number): number {
  return manualRange(identity, slot)?.step ?? 1;
}

/** The step of a field: of a time in hundredths of a second, of a position 1. */
export function stepOf(identity: Identity, field: ProgramField): number {
  return field.kind === 'time' ? timeStep(identity, field.slot) : 1;
}

/**
 * How far a field can be moved. A time keeps its place among its neighbours, at least one step away from each; a
 * neighbour that it has reached or passed already does not hold it there. The motor stop lies between launch and DT.
 * @param free lifts the neighbours.
 */
export function limitsOf(program: TimerProgram, field: ProgramField, free = false): Limits {
  if (field.kind !== 'time') return { min: 0, max: MAX_POSITION };
  const { identity, times } = program;
  const { slot } = field;
  const step = timeStep(identity, slot);
  const largest = Math.floor(MAX_TIME / step) * step;
  if (free) return { min: 0, max: largest };
  const time = times[slot] as number;
  const before = slot > 1 ? (times[slot - 1] as number) : 0;
  const after = times[slot === 0 ? identity.functions : slot + 1] ?? MAX_TIME + 1;
  const min = before < time ? Math.ceil((before + 1) / step) * step : before === time ? time : 0;
  const max = after > time ? Math.floor((after - 1) / step) * step : after === time ? time : largest;
  // Between close neighbours there may be no whole step: then it stays where it is.
  return { min: Math.min(min, time), max: Math.max(max, time) };
}

/** The nearest value that a field can be moved to: a whole step inside of its limits. */
export function snapped(program: TimerProgram, field: ProgramField, value: number, free = false): number {
  const step = stepOf(program.identity, field);
  return within(Math.round(value / step) * step, limitsOf(program, field, free));
}

/** The value some steps up or down. From between two steps the first one goes to the next of them. */
export function stepped(program: TimerProgram, field: ProgramField, steps: number, free = false): number {
  const step = stepOf(program.identity, field);
  const value = valueAt(program, field) ?? 0;
  const start = steps > 0 ? Math.floor(value / step) : Math.ceil(value / step);
  return within((start + steps) * step, limitsOf(program, field, free));
}

function within(value: number, { min, max }: Limits): number {
  return Math.min(max, Math.max(min, value));
}

/** One movement of one handle, from taking hold to letting go. */
export class DragEdit {
  readonly program: TimerProgram;
  readonly field: ProgramField;
  readonly #onEdit: OnEdit;
  readonly #original: number;
  #last: number;
  #moved = false;

  /** @param program as it is when the handle is taken. */
  constructor(program: TimerProgram, field: ProgramField, onEdit: OnEdit) {
    this.program = program;
    this.field = field;
    this.#onEdit = onEdit;
    this.#original = this.#last = valueAt(program, field) ?? 0;
  }

  /** The value that the handle stands at. */
  get value(): number {
    return this.#last;
  }

  move(value: number): void {
    if (value === this.#last) return;
    this.#last = value;
    this.#moved = true;
    this.#tell('moving');
  }

  /** The handle is let go. Nothing is said of a movement that was none. */
  finish(): void {
    if (this.#moved) this.#tell(this.#last === this.#original ? 'back' : 'done');
    this.#moved = false;
  }

  /** Puts back what was there. */
  cancel(): void {
    this.#last = this.#original;
    this.finish();
  }

  #tell(phase: DragPhase): void {
    const { field } = this;
    const key = fieldKey(field);
    const name: StepName = { code: 'move-mark', params: { field: key } };
    this.#onEdit(setValues(name, [{ field, value: this.#last }], groupOf('move', key)), phase);
  }
}
