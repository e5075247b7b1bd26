import type { TimerProgram } from '../../../program/index.js';
import type { OnEdit } from '../drag.js';
import type { Geometry } from '../geometry.js';

/** A place of the picture, in pixels from its upper left corner. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** What the pointer works on, as it was drawn last. */
export interface Target {
  readonly svg: SVGSVGElement;
  readonly geometry: Geometry;
  /** The program as it is by now. */
  readonly now: () => TimerProgram;
  /** Absent when nothing can be changed. */
  readonly onEdit: OnEdit | undefined;
}

/** What a pointer has reported. */
export interface Report {
  readonly point: Point;
  /** Whether Alt is held: a time then passes its neighbours. */
  readonly free: boolean;
  /** Whether it is a finger. */
  readonly coarse: boolean;
}

/** What is being done with the pointer: it hovers, looks, moves a handle, or pinches. */
export interface Gesture {
  /** Whether the finger that does this scrolls the page no more. */
  readonly holdsPage: boolean;
  /**
   * The pointer has moved; called once for each frame that is drawn, with the last report.
   * @returns whether it has to be called again at the next frame, even if the pointer stands still.
   */
  move(target: Target, report: Report): boolean;
  /** The pointer was let go. */
  up(target: Target, report: Report): void;
  /** Nothing was meant by it: what it changed is put back. */
  cancel(): void;
}
