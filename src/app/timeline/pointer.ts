import { type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { aimAt, lineAt, type Point, timeAt } from './aim.js';
import type { Arrangement } from './arrangement.js';
import { DragEdit, limitsOf, type OnEdit, snapped } from './drag.js';
import type { Layout } from './layout.js';
import type { TimelineModel } from './view-model.js';

/** What the pointer works on, as it was drawn last. */
export interface Target {
  readonly svg: SVGSVGElement;
  readonly arrangement: Arrangement;
  /** The program as it is by now. */
  readonly now: () => TimerProgram;
  readonly onEdit: OnEdit | undefined;
}

interface Move {
  readonly kind: 'move';
  readonly id: number;
  readonly field: ProgramField;
  readonly from: Point;
  /** From the pointer to where the value lies. */
  readonly offset: Point;
}

/** The last report of a pointer. */
interface Latest {
  readonly point: Point;
  /** Whether the neighbours are lifted. */
  readonly free: boolean;
  readonly coarse: boolean;
}

/** What a pointer that is down does. */
type Doing =
  | Move
  | { readonly kind: 'look'; readonly id: number; readonly from: Point; last: Point; pans: boolean; moved: boolean }
  | { readonly kind: 'pinch'; readonly places: ReadonlyMap<number, number> };

/** A pointer that moves less than this has not moved, in pixels. */
const STILL = 4;
/** Beside the plot the picture follows a handle, by this share of the way it is beside it, in each frame. */
const FOLLOW = 0.02;

/**
 * Mouse, pen and fingers on a timeline. What they do is looked at once for each frame that is drawn, however often the
 * pointer reports.
 */
export class PointerControl {
  readonly #model: TimelineModel;
  readonly #target: () => Target | null;
  readonly #down = new Map<number, Point>();
  #doing: Doing | null = null;
  #latest: Latest | null = null;
  #frame = 0;

  constructor(model: TimelineModel, target: () => Target | null) {
    this.#model = model;
    this.#target = target;
  }

  readonly down = (event: PointerEvent): void => {
    const target = this.#target();
    if (!target || event.button > 0) return;
    const point = pointIn(target.svg, event);
    this.#model.pointed.value = null;
    this.#down.set(event.pointerId, point);
    if (this.#down.size === 1) this.#listen();
    if (this.#down.size === 2) this.#pinch(target);
    if (this.#down.size === 1) this.#take(event, target, point);
  };

  /** The first finger, or the mouse, is down: on a handle, or on what lies behind. */
  #take(event: PointerEvent, target: Target, point: Point): void {
    const model = this.#model;
    const field = this.#aim(target, point, event.pointerType === 'touch');
    if (!field || !target.onEdit) {
      const pans = model.zoomed;
      this.#doing = { kind: 'look', id: event.pointerId, from: point, last: point, pans, moved: false };
      this.#note(event, target);
      return;
    }
    const { layout } = target.arrangement;
    const program = target.now();
    // What is moved keeps its distance from the pointer.
    const value = valueAt(program, field) ?? 0;
    const offset = { x: layout.x(value) - point.x, y: layout.y(value) - point.y };
    this.#doing = { kind: 'move', id: event.pointerId, field, from: point, offset };
    model.asked.value = null;
    if (field.kind === 'position') model.front.value = field.servo;
    model.wanted.value = field;
    model.moving.value = { edit: new DragEdit(program, field, target.onEdit), scale: layout.scale };
  }

  /** A finger on a handle, or a second one, does not scroll the page; a finger beside the handles does. Comes after {@link down}. */
  readonly touch = (event: TouchEvent): void => {
    if (this.#doing && this.#doing.kind !== 'look') event.preventDefault();
  };

  /** The mouse passes over: it asks for the time, and its pointer says what could be taken hold of. */
  readonly hover = (event: PointerEvent): void => {
    const target = this.#target();
    if (target && !this.#doing && event.pointerType !== 'touch') this.#note(event, target);
  };

  readonly leave = (event: PointerEvent): void => {
    if (event.pointerType === 'touch' || this.#doing) return;
    this.#latest = null;
    this.#model.asked.value = null;
    this.#model.pointed.value = null;
  };

  /** With Ctrl, as pinching a touchpad gives it, the wheel zooms; sideways it moves what is in view; else it scrolls the page. */
  readonly wheel = (event: WheelEvent): void => {
    const target = this.#target();
    if (!target) return;
    const { layout } = target.arrangement;
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault();
      this.#model.zoom(1.0025 ** -pixels(event.deltaY, event), placeAt(target, pointIn(target.svg, event).x));
    } else if (this.#model.zoomed && (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY))) {
      event.preventDefault();
      this.#model.pan(pixels(event.deltaX || event.deltaY, event) / layout.width);
    }
  };

  readonly doubleClick = (event: MouseEvent): void => {
    const target = this.#target();
    if (target && !this.#aim(target, pointIn(target.svg, event), false)) this.#model.fit();
  };

  /** Lets go of everything, putting back what was being moved. */
  readonly cancel = (): void => {
    this.#model.moving.value?.edit.cancel();
    this.#end();
  };

  #aim({ arrangement, onEdit }: Target, point: Point, coarse: boolean): ProgramField | null {
    return onEdit ? aimAt(arrangement, this.#model.front.value, point, coarse) : null;
  }

  #pinch(target: Target): void {
    this.#model.moving.value?.edit.cancel();
    this.#model.moving.value = null;
    this.#model.asked.value = null;
    const places = new Map([...this.#down].map(([id, { x }]) => [id, placeAt(target, x)]));
    this.#doing = { kind: 'pinch', places };
  }

  readonly #moved = (event: PointerEvent): void => {
    const target = this.#target();
    if (target && this.#down.has(event.pointerId)) this.#note(event, target);
  };

  readonly #up = (event: PointerEvent): void => {
    this.#moved(event);
    if (!this.#down.delete(event.pointerId)) return;
    const doing = this.#doing;
    if (doing && doing.kind !== 'pinch' && doing.id === event.pointerId) {
      this.#act();
      this.#model.moving.value?.edit.finish();
      const target = this.#target();
      if (doing.kind === 'look' && !doing.moved && target) {
        const line = lineAt(target.arrangement, this.#model.front.value, doing.from, event.pointerType === 'touch');
        if (line) this.#model.front.value = line.servo;
      }
    }
    this.#end();
  };

  readonly #lost = (event: PointerEvent): void => {
    // The browser has taken the finger for scrolling the page: nothing was meant by it here.
    if (this.#down.delete(event.pointerId)) this.cancel();
  };

  readonly #key = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || this.#doing?.kind !== 'move') return;
    event.preventDefault();
    event.stopPropagation();
    this.cancel();
  };

  #listen(): void {
    window.addEventListener('pointermove', this.#moved);
    window.addEventListener('pointerup', this.#up);
    window.addEventListener('pointercancel', this.#lost);
    window.addEventListener('keydown', this.#key, { capture: true });
  }

  #end(): void {
    this.#doing = null;
    this.#latest = null;
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    if (this.#model.moving.value) {
      this.#model.moving.value = null;
      this.#model.settle();
    }
    if (this.#down.size > 0) return;
    window.removeEventListener('pointermove', this.#moved);
    window.removeEventListener('pointerup', this.#up);
    window.removeEventListener('pointercancel', this.#lost);
    window.removeEventListener('keydown', this.#key, { capture: true });
  }

  #note(event: PointerEvent, { svg }: Target): void {
    const point = pointIn(svg, event);
    if (this.#down.has(event.pointerId)) this.#down.set(event.pointerId, point);
    this.#latest = { point, free: event.altKey, coarse: event.pointerType === 'touch' };
    if (this.#frame === 0) this.#frame = requestAnimationFrame(this.#drawn);
  }

  readonly #drawn = (): void => {
    this.#frame = 0;
    this.#act();
  };

  /** What the last report of the pointer means. */
  #act(): void {
    const target = this.#target();
    const latest = this.#latest;
    if (!target || !latest) return;
    const { point } = latest;
    const doing = this.#doing;
    if (doing?.kind === 'move') {
      this.#move(target.arrangement.layout, doing, latest);
      return;
    }
    this.#latest = null;
    if (doing?.kind === 'pinch') {
      this.#pinched(target, doing.places);
      return;
    }
    const { arrangement } = target;
    if (!doing) {
      const aim = this.#aim(target, point, latest.coarse);
      target.svg.setAttribute('data-aim', aim?.kind ?? '');
      this.#model.pointed.value = aim;
    } else {
      doing.moved ||= Math.abs(point.x - doing.from.x) > STILL;
      if (doing.pans && doing.moved) {
        this.#model.pan((doing.last.x - point.x) / arrangement.layout.width);
        doing.last = point;
        return;
      }
    }
    this.#model.asked.value = timeAt(arrangement, point.x);
  }

  #move(layout: Layout, { field, from, offset }: Move, { point, free }: Latest): void {
    const edit = this.#model.moving.value?.edit;
    if (!edit) return;
    if (field.kind === 'position') {
      const moved = Math.abs(point.y - from.y) >= 1;
      if (moved) edit.move(snapped(edit.program, field, layout.position(point.y + offset.y)));
      return;
    }
    if (Math.abs(point.x - from.x) < 1) return;
    const { left, right } = layout.box;
    const beside = Math.min(0, point.x - left) + Math.max(0, point.x - right);
    const { min, max } = limitsOf(edit.program, field, free);
    if ((beside > 0 && edit.value < max) || (beside < 0 && edit.value > min)) {
      this.#model.pan((beside * FOLLOW) / layout.width, true);
      // Nothing reports while the pointer stands still beside the plot.
      if (this.#frame === 0) this.#frame = requestAnimationFrame(this.#drawn);
    }
    const x = Math.min(right, Math.max(left, point.x + offset.x));
    edit.move(snapped(edit.program, field, layout.time(x), free));
  }

  #pinched({ arrangement: { layout } }: Target, places: ReadonlyMap<number, number>): void {
    const [a, b] = [...this.#down].map(([id, { x }]) => ({
      place: places.get(id) ?? 0,
      share: (x - layout.box.left) / layout.width,
    }));
    if (!a || !b || Math.abs(a.share - b.share) < 0.02) return;
    this.#model.hold(a, b);
  }
}

function placeAt({ arrangement: { layout } }: Target, x: number): number {
  return layout.view.start + ((x - layout.box.left) / layout.width) * layout.view.span;
}

function pointIn(svg: SVGSVGElement, event: MouseEvent): Point {
  const { left, top } = svg.getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}

/** The way of a wheel in pixels, whether it counts in those, in lines or in pages. */
function pixels(way: number, { deltaMode }: WheelEvent): number {
  return way * ([1, 16, 400][deltaMode] ?? 1);
}
