import type { TimerProgram } from '../../../program/index.js';
import type { OnEdit } from '../drag.js';
import type { Geometry } from '../geometry.js';

/** A place of the picture, in pixels from its upper left corner. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** What the pointer works on, as last drawn. */
export interface Target {
  readonly svg: SVGSVGElement;
  readonly geometry: Geometry;
  /** Gives the present program. */
  readonly now: () => TimerProgram;
  /** Absent when nothing can be changed. */
  readonly onEdit: OnEdit | undefined;
}

/** A report of the pointer. */
export interface Report {
  readonly point: Point;
  /** Whether Alt is held, so that a time may pass its neighbours. */
  readonly free: boolean;
  /** Whether it is a finger. */
  readonly coarse: boolean;
}

/** What the pointer does: it hovers, looks, moves a handle, or pinches. */
export interface Gesture {
  /** Whether its finger no longer scrolls the page. */
  readonly holdsPage: boolean;
  /**
   * The pointer has moved. Called once for each frame, with the last report.
   * @returns whether to call it again at the next frame, even if the pointer stands still.
   */
  move(target: Target, report: Report): boolean;
  /** The pointer was released. */
  up(target: Target, report: Report): void;
  /** The gesture was not meant: puts back what it changed. */
  cancel(): void;
}
