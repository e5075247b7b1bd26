import type { Duty, ServoUse, TimerProgram } from '../../../program/index.js';
import { MAX_POSITION } from '../../../protocol/index.js';

/** The surfaces that the sketch can turn. */
export const SURFACES = ['rudder', 'tailplane', 'wing'] as const;
export type Surface = (typeof SURFACES)[number];

/**
 * How far a surface turns in the sketch at the ends of a servo's travel, in degrees: down or left, up or right. Chosen
 * to be visible; they are those of no real model.
 */
const SWING: Readonly<Record<Surface, readonly [number, number]>> = {
  rudder: [28, 28],
  tailplane: [16, 42],
  wing: [8, 8],
};

/** The first servos of most models. Nobody can guess any further ones. */
const USUAL: readonly Duty[] = ['rudder', 'tailplane', 'wing'];
const MIDDLE = MAX_POSITION / 2;

/**
 * A guess of what the servos move: S1 the rudder, S2 the tailplane, S3 the wing; a single servo turns a disc. Each uses
 * the travel that the program uses, and at DT the tailplane goes up.
 */
export function guessedUses({ positions }: TimerProgram): ServoUse[] {
  return positions.map((row, servo) => {
    const duty: Duty = positions.length === 1 ? 'release' : (USUAL[servo] ?? 'other');
    const steps = row.map(onWay);
    const most = Math.max(...steps.map((at) => Math.abs(at - MIDDLE)));
    // A rudder is trimmed around its middle, so that a turn looks like one.
    const isRudder = duty === 'rudder';
    const low = isRudder ? MIDDLE - most : Math.min(...steps);
    const high = isRudder ? MIDDLE + most : Math.max(...steps);
    const glide = steps.at(-2) ?? 0;
    const reversed = duty === 'tailplane' && (steps.at(-1) ?? 0) < glide;
    return { duty, name: '', low, high, reversed };
  });
}

/** How a surface stands. */
export interface Turn {
  /** From the fuselage. Above 0: trailing edge up, for a rudder to the right. */
  readonly degrees: number;
  /** The servo that turns it; null for a released tailplane. */
  readonly servo: number | null;
}

/** How far a released tailplane tips up. */
const LET_GO: Turn = { degrees: 42, servo: null };

/** How all surfaces stand at a slot; null for one that no servo turns. At DT a servo may release the tailplane. */
export function turnsAt(
  program: TimerProgram,
  slot: number,
  uses: readonly ServoUse[],
): Readonly<Record<Surface, Turn | null>> {
  const [rudder, tailplane, wing] = SURFACES.map((surface) => turnOf(program, slot, surface, uses));
  const letGo = slot === program.identity.functions && isLetGo(program, uses);
  return { rudder: rudder ?? null, tailplane: letGo ? LET_GO : (tailplane ?? null), wing: wing ?? null };
}

/** The tailplane of the glide is drawn straight. The first of several servos turns a surface. */
function turnOf(program: TimerProgram, slot: number, surface: Surface, uses: readonly ServoUse[]): Turn | null {
  const servo = uses.findIndex(({ duty }) => duty === surface);
  const use = uses[servo];
  const row = program.positions[servo];
  if (!use || !row) return null;
  const straight = surface === 'tailplane' ? shareOf(use, row.at(-2) ?? 0) : 0.5;
  const off = shareOf(use, row[slot] ?? 0) - straight;
  if (off === 0) return { degrees: 0, servo };
  const [down, up] = SWING[surface];
  const rising = up / (1 - straight);
  // A small trim looks small in both directions.
  const turn = off * (off > 0 ? rising : Math.min(rising, down / straight));
  return { degrees: Math.round(turn * 10) / 10, servo };
}

/** Where a position lies on the servo's travel: 0 is fully down or left, 1 fully up or right. */
function shareOf({ low, high, reversed }: ServoUse, position: number): number {
  const share = high > low ? Math.min(1, Math.max(0, (onWay(position) - low) / (high - low))) : 0.5;
  return reversed ? 1 - share : share;
}

/** A timer may hold a position past the last step. */
function onWay(position: number): number {
  return Math.min(MAX_POSITION, Math.max(0, position));
}

/** The servos that move at DT. If none moves, DT brings no model down. */
export function movedAtDt({ positions }: TimerProgram): number[] {
  return positions.flatMap((row, servo) => (row.at(-1) === row.at(-2) ? [] : [servo]));
}

/** Whether the tailplane tips up at DT because a servo releases it. */
function isLetGo(program: TimerProgram, uses: readonly ServoUse[]): boolean {
  return movedAtDt(program).some((servo) => uses[servo]?.duty === 'release');
}
