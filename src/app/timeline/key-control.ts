import { fieldKey, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { DragEdit, limitsOf, type Shown, stepped } from './drag.js';
import { marksOf } from './flight.js';
import { handlePlaces } from './geometry.js';
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
const ZOOM = 1.5;

type Action = (() => void) | null;

/**
 * Keys on a timeline. On a handle they move it: while a key is held it is one movement, which ends when the key is
 * released. On the picture as a whole left and right go from mark to mark, up and down from servo to servo; + and −
 * zoom.
 */
export class KeyControl {
  readonly #model: TimelineModel;
  readonly #shown: () => Shown | null;
  #edit: DragEdit | null = null;

  constructor(model: TimelineModel, shown: () => Shown | null) {
    this.#model = model;
    this.#shown = shown;
  }

  readonly down = (event: KeyboardEvent): void => {
    const shown = this.#shown();
    if (!shown || event.ctrlKey || event.metaKey || event.altKey) return;
    const field = fieldOf(event.target, shown);
    const action = field ? this.#onHandle(event, field, shown) : this.#onPicture(event.key, shown);
    if (!action) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  };

  /** The key was released, or the handle has lost the focus. */
  readonly up = (): void => {
    this.#edit?.end(true);
    this.#edit = null;
  };

  #onHandle(event: KeyboardEvent, field: ProgramField, { svg, now, onEdit }: Shown): Action {
    if (event.key === 'Escape') {
      return () => {
        if (this.#edit) this.#edit.end(false);
        else svg.focus();
        this.#edit = null;
      };
    }
    const program = now();
    const value = valueByKey(program, field, event);
    if (value === null || !onEdit) return null;
    return () => {
      this.#model.ask(null);
      // While a key is held, the pointer may select another servo, and this is a handle of that one.
      if (this.#edit && fieldKey(this.#edit.field) !== fieldKey(field)) this.up();
      this.#edit ??= new DragEdit(now, field, onEdit);
      if (value !== valueAt(program, field)) this.#edit.move(value);
    };
  }

  #onPicture(key: string, { svg, geometry, anchor }: Shown): Action {
    const model = this.#model;
    const { program, layout } = geometry;
    const marks = [0, ...marksOf(program)];
    const ask = (time: number | null) => (): void => {
      model.tell(time === null ? null : { time });
      if (time !== null) model.reveal(layout.scale.place(time));
    };
    const now = model.asked.value;
    const toServo = (by: number) => (): void => {
      const servo = (geometry.front ?? 0) + by;
      model.tell({ servo: Math.max(0, Math.min(program.identity.servos - 1, servo)) });
    };
    switch (key) {
      case '+':
      case '=':
        return () => model.zoom(ZOOM, anchor());
      case '-':
        return () => model.zoom(1 / ZOOM, anchor());
      case '0':
        return () => model.fit();
      case 'ArrowRight':
        return ask(now === null ? 0 : Math.min(layout.scale.end, ...marks.filter((time) => time > now)));
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
}

/** The value that a key gives to a field; null for any other key. Shift makes ten steps. */
function valueByKey(program: TimerProgram, field: ProgramField, { key, shiftKey }: KeyboardEvent): number | null {
  if (key === 'Home') return limitsOf(program, field).min;
  if (key === 'End') return limitsOf(program, field).max;
  const steps = STEPS[key];
  return steps === undefined ? null : stepped(program, field, shiftKey ? steps * MANY : steps);
}

/** Gives a handle the keyboard focus. */
export function focusHandle(svg: Element, field: ProgramField): void {
  svg.querySelector<SVGElement>(`[data-field="${fieldKey(field)}"]`)?.focus({ preventScroll: true });
}

/** The field of a handle; null for the picture as a whole. */
export function fieldOf(target: EventTarget | null, { geometry }: Shown): ProgramField | null {
  const key = target instanceof Element && target.getAttribute('data-field');
  return handlePlaces(geometry).find(({ field }) => fieldKey(field) === key)?.field ?? null;
}
