import type { TimerProgram } from '../../../program/index.js';
import { MAX_POSITION } from '../../../protocol/index.js';

/** What a servo can move on the sketch of a model. */
export const SURFACES = ['rudder', 'tailplane', 'wing'] as const;
export type Surface = (typeof SURFACES)[number];

/** Which servo moves a surface, counted from 0, and in which sense. */
export interface Linkage {
  /** Null where nothing moves it. */
  readonly servo: number | null;
  readonly reversed: boolean;
}

export type Linkages = Readonly<Record<Surface, Linkage>>;

/** S1 moves the rudder, S2 the tailplane, S3 the wing, as far as there are so many servos. */
export function usualLinkages(servos: number): Linkages {
  const linkage = (servo: number): Linkage => ({ servo: servo < servos ? servo : null, reversed: false });
  return { rudder: linkage(0), tailplane: linkage(1), wing: linkage(2) };
}

/**
 * How far a surface is turned at a slot of a program: -1 at one end of the servo's way, 0 in its middle, 1 at the other
 * end. Null where nothing moves it. What angle that is in a model is not known.
 */
export function deflection({ positions }: TimerProgram, slot: number, { servo, reversed }: Linkage): number | null {
  const position = servo === null ? undefined : positions[servo]?.[slot];
  if (position === undefined) return null;
  const turned = Math.min(1, position / (MAX_POSITION / 2) - 1);
  return reversed ? -turned : turned;
}
