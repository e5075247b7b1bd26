import type { TimelineModel } from '../view-model.js';
import type { Gesture, Point, Report, Target } from './gesture.js';
import { Hover } from './hover.js';
import { Look } from './look.js';
import { MoveHandle } from './move-handle.js';
import { Pinch } from './pinch.js';
import { fieldUnder, placeUnder } from './under-pointer.js';

/** How much a wheel zooms for each pixel that it turns. */
const ZOOM = 1.0025;

/**
 * Mouse, pen and fingers on a timeline. They make one gesture after another, which hears of them once for each frame,
 * however often the pointer reports.
 */
export class PointerControl {
  readonly #model: TimelineModel;
  readonly #target: () => Target | null;
  readonly #hover: Hover;
  /** Where each pressed pointer is. */
  readonly #down = new Map<number, Point>();
  #gesture: Gesture;
  /** A report that the gesture has not had yet, or gets again at the next frame. */
  #latest: Report | null = null;
  #frame = 0;

  constructor(model: TimelineModel, target: () => Target | null) {
    this.#model = model;
    this.#target = target;
    this.#hover = new Hover(model);
    this.#gesture = this.#hover;
  }

  readonly down = (event: PointerEvent): void => {
    const target = this.#target();
    if (!target || event.button > 0) return;
    this.#model.pointAt(null);
    this.#down.set(event.pointerId, pointIn(target.svg, event));
    if (this.#down.size === 1) {
      this.#listen();
      this.#gesture = this.#begun(event, target);
      if (!this.#gesture.holdsPage) this.#note(event, target);
    } else if (this.#down.size === 2) {
      this.#gesture.cancel();
      this.#gesture = new Pinch(this.#model, target, this.#down);
    }
  };

  /** The first finger, or the mouse, is down: on a handle, or beside the handles. */
  #begun(event: PointerEvent, target: Target): Gesture {
    const { onEdit } = target;
    const from = pointIn(target.svg, event);
    const field = fieldUnder(target, this.#model.front.value, from, isFinger(event));
    return field && onEdit ? new MoveHandle(this.#model, target, { field, from, onEdit }) : new Look(this.#model, from);
  }

  /**
   * A finger on a handle, or a second finger, does not scroll the page; a finger beside the handles does.
   * Comes after {@link down}.
   */
  readonly touch = (event: TouchEvent): void => {
    if (this.#gesture.holdsPage) event.preventDefault();
  };

  readonly hover = (event: PointerEvent): void => {
    const target = this.#target();
    if (target && this.#gesture === this.#hover && !isFinger(event)) this.#note(event, target);
  };

  readonly leave = (event: PointerEvent): void => {
    if (isFinger(event) || this.#gesture !== this.#hover) return;
    this.#latest = null;
    this.#model.ask(null);
    this.#model.pointAt(null);
  };

  /**
   * With Ctrl, which pinching a touchpad also gives, the wheel zooms. Sideways it moves the view.
   * Otherwise it scrolls the page.
   */
  readonly wheel = (event: WheelEvent): void => {
    const target = this.#target();
    if (!target) return;
    const { layout } = target.geometry;
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault();
      this.#model.zoom(ZOOM ** -pixels(event.deltaY, event), placeUnder(layout, pointIn(target.svg, event).x));
    } else if (this.#model.zoomed && (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY))) {
      event.preventDefault();
      this.#model.pan(pixels(event.deltaX || event.deltaY, event) / layout.width);
    }
  };

  readonly doubleClick = (event: MouseEvent): void => {
    const target = this.#target();
    if (target && !fieldUnder(target, this.#model.front.value, pointIn(target.svg, event), false)) this.#model.fit();
  };

  /** Releases everything and puts back what was being moved. */
  readonly cancel = (): void => {
    this.#gesture.cancel();
    this.#end();
  };

  readonly #moved = (event: PointerEvent): void => {
    const target = this.#target();
    if (!target || !this.#down.has(event.pointerId)) return;
    // The button was released where the page could not hear it, as over another window or with another button down.
    if ((event.buttons & 1) === 0) this.#lost(event);
    else {
      this.#down.set(event.pointerId, pointIn(target.svg, event));
      this.#note(event, target);
    }
  };

  readonly #up = (event: PointerEvent): void => {
    if (!this.#down.delete(event.pointerId)) return;
    const target = this.#target();
    if (target) this.#gesture.up(target, reportOf(event, target));
    this.#end();
  };

  /** The browser uses the finger to scroll the page, so it was not meant for the picture. */
  readonly #lost = (event: PointerEvent): void => {
    if (this.#down.delete(event.pointerId)) this.cancel();
  };

  readonly #key = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || !(this.#gesture instanceof MoveHandle)) return;
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
    this.#gesture = this.#hover;
    this.#latest = null;
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    if (this.#down.size > 0) return;
    window.removeEventListener('pointermove', this.#moved);
    window.removeEventListener('pointerup', this.#up);
    window.removeEventListener('pointercancel', this.#lost);
    window.removeEventListener('keydown', this.#key, { capture: true });
  }

  #note(event: PointerEvent, target: Target): void {
    this.#latest = reportOf(event, target);
    this.#askForFrame();
  }

  #askForFrame(): void {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(this.#drawn);
  }

  readonly #drawn = (): void => {
    this.#frame = 0;
    const target = this.#target();
    const latest = this.#latest;
    if (!target || !latest) return;
    if (this.#gesture.move(target, latest)) this.#askForFrame();
    else this.#latest = null;
  };
}

function isFinger({ pointerType }: PointerEvent): boolean {
  return pointerType === 'touch';
}

function reportOf(event: PointerEvent, { svg }: Target): Report {
  return { point: pointIn(svg, event), free: event.altKey, coarse: isFinger(event) };
}

function pointIn(svg: SVGSVGElement, event: MouseEvent): Point {
  const { left, top } = svg.getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}

/** The way of a wheel in pixels, whether it counts in pixels, lines or pages. */
function pixels(way: number, { deltaMode }: WheelEvent): number {
  return way * ([1, 16, 400][deltaMode] ?? 1);
}
