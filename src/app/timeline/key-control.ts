import { fieldKey, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { DragEdit, limitsOf, type OnEdit, stepped } from './drag.js';
import { marksOf } from './flight.js';
import type { Geometry } from './geometry.js';
import type { Scale } from './scale.js';
import type { TimelineModel } from './view-model.js';

const STEPS: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
  PageUp: 10,
  PageDown: -10,
};
const MANY = 10;

/** The value that a key gives to a field; null for any other key. Shift makes ten steps. */
function valueByKey(program: TimerProgram, field: ProgramField, event: KeyboardEvent): number | null {
  if (event.ctrlKey || event.metaKey) return null;
  if (event.key === 'Home') return limitsOf(program, field).min;
  if (event.key === 'End') return limitsOf(program, field).max;
  const steps = STEPS[event.key];
  if (steps === undefined) return null;
  return stepped(program, field, event.shiftKey ? steps * MANY : steps);
}

/** Keys on a handle. While a key is held it is one movement, which ends when the key is released. */
export class HandleKeys {
  readonly #model: TimelineModel;
  #edit: DragEdit | null = null;

  constructor(model: TimelineModel) {
    this.#model = model;
  }

  down(event: KeyboardEvent, now: () => TimerProgram, field: ProgramField, onEdit: OnEdit): void {
    if (event.key === 'Escape') {
      if (this.#edit) this.#edit.cancel();
      else (event.currentTarget as Element).closest<SVGElement>('svg')?.focus();
      this.#edit = null;
      take(event);
      return;
    }
    const program = now();
    const value = valueByKey(program, field, event);
    if (value === null) return;
    take(event);
    this.#model.ask(null);
    this.#edit ??= new DragEdit(now, field, onEdit);
    if (value !== valueAt(program, field)) this.#edit.move(value);
  }

  /** The key was released, or the handle has lost the focus. */
  readonly up = (): void => {
    this.#edit?.finish();
    this.#edit = null;
  };
}

/** Gives a handle the keyboard focus. */
export function focusHandle(svg: Element, field: ProgramField): void {
  svg.querySelector<SVGElement>(`[data-field="${fieldKey(field)}"]`)?.focus({ preventScroll: true });
}

const ZOOM = 1.5;

/**
 * Keys on the picture as a whole: left and right go from mark to mark, up and down from servo to servo; + and − zoom.
 * @param anchor the place of the scale around which to zoom.
 */
export function pictureKey(
  event: KeyboardEvent,
  model: TimelineModel,
  { program, layout }: Geometry,
  anchor: number | undefined,
): void {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target !== event.currentTarget) return;
  const svg = event.currentTarget as SVGElement;
  const action = actionOf(event.key, svg, model, program, layout.scale, anchor);
  if (!action) return;
  take(event);
  action();
}

function actionOf(
  key: string,
  svg: SVGElement,
  model: TimelineModel,
  program: TimerProgram,
  scale: Scale,
  anchor: number | undefined,
): (() => void) | null {
  const { asked } = model;
  const marks = [0, ...marksOf(program)];
  const ask = (time: number | null) => (): void => {
    model.askAloud(time);
    if (time !== null) model.reveal(scale.place(time));
  };
  const now = asked.value;
  const toServo = (by: number) => (): void => {
    const last = program.identity.servos - 1;
    model.bringToFrontAloud(Math.max(0, Math.min(last, Math.min(last, model.front.value) + by)));
  };
  switch (key) {
    case '+':
    case '=':
      return () => model.zoom(ZOOM, anchor);
    case '-':
      return () => model.zoom(1 / ZOOM, anchor);
    case '0':
      return () => model.fit();
    case 'ArrowRight':
      return ask(now === null ? 0 : Math.min(scale.end, ...marks.filter((time) => time > now)));
    case 'ArrowLeft':
      return ask(now === null ? Math.max(...marks) : Math.max(0, ...marks.filter((time) => time < now)));
    case 'ArrowUp':
      return toServo(-1);
    case 'ArrowDown':
      return toServo(1);
    case 'Home':
      return ask(0);
    case 'End':
      return ask(Math.max(...marks));
    case 'Enter':
      return () => focusHandle(svg, { kind: 'time', slot: 1 });
    case 'Escape':
      return now === null ? null : ask(null);
    default:
      return null;
  }
}

function take(event: KeyboardEvent): void {
  event.preventDefault();
  event.stopPropagation();
}
