import type { Duty, ServoUse, TimerProgram } from '../../../program/index.js';
import { MAX_POSITION } from '../../../protocol/index.js';

/** What the sketch of a model can turn. */
export const SURFACES = ['rudder', 'tailplane', 'wing'] as const;
export type Surface = (typeof SURFACES)[number];

/**
 * How far a surface turns on the sketch at the ends of a servo's way, in degrees: down or to the left, up or to the
 * right. Chosen to be seen; not those of any model.
 */
const SWING: Readonly<Record<Surface, readonly [number, number]>> = {
  rudder: [28, 28],
  tailplane: [16, 42],
  wing: [8, 8],
};

/** The first servos of most models; what comes after them nobody can guess. */
const USUAL: readonly Duty[] = ['rudder', 'tailplane', 'wing'];
const MIDDLE = MAX_POSITION / 2;

/**
 * What the servos may move, where the pilot has not said it: S1 the rudder, S2 the tailplane, S3 the wing; a servo that
 * is alone turns a disc. Each uses the way that the program uses, and at DT the tailplane goes up.
 */
export function guessedUses({ positions }: TimerProgram): ServoUse[] {
  return positions.map((row, servo) => {
    const duty: Duty = positions.length === 1 ? 'release' : (USUAL[servo] ?? 'other');
    const steps = row.map(onWay);
    const most = Math.max(...steps.map((at) => Math.abs(at - MIDDLE)));
    // A rudder is trimmed about its middle, and a turn is seen as one.
    const isRudder = duty === 'rudder';
    const low = isRudder ? MIDDLE - most : Math.min(...steps);
    const high = isRudder ? MIDDLE + most : Math.max(...steps);
    const glide = steps.at(-2) ?? 0;
    const reversed = duty === 'tailplane' && (steps.at(-1) ?? 0) < glide;
    return { duty, name: '', low, high, reversed };
  });
}

/**
 * How a surface stands at a slot of a program, in degrees from the fuselage: above 0 its trailing edge is up, that of a
 * rudder to the right. The tailplane of the glide is drawn straight. Null where no servo turns it.
 */
export function turnOf(
  program: TimerProgram,
  slot: number,
  surface: Surface,
  uses: readonly ServoUse[],
): number | null {
  const servo = servoOf(surface, uses);
  const use = uses[servo];
  const row = program.positions[servo];
  if (!use || !row) return null;
  const straight = surface === 'tailplane' ? shareOf(use, row.at(-2) ?? 0) : 0.5;
  const off = shareOf(use, row[slot] ?? 0) - straight;
  if (off === 0) return 0;
  const [down, up] = SWING[surface];
  const rising = up / (1 - straight);
  // A small trim looks small on both sides.
  const turn = off * (off > 0 ? rising : Math.min(rising, down / straight));
  return Math.round(turn * 10) / 10;
}

/** The servo that turns a surface, the first where there are several; -1 if there is none. */
export function servoOf(surface: Surface, uses: readonly ServoUse[]): number {
  return uses.findIndex(({ duty }) => duty === surface);
}

/** Where a position lies on the way that the servo uses: 0 is all down or to the left, 1 all up or to the right. */
function shareOf({ low, high, reversed }: ServoUse, position: number): number {
  const share = high > low ? Math.min(1, Math.max(0, (onWay(position) - low) / (high - low))) : 0.5;
  return reversed ? 1 - share : share;
}

/** A timer may hold a position past the last step. */
function onWay(position: number): number {
  return Math.min(MAX_POSITION, Math.max(0, position));
}

/** What DT does: which servos move then. A DT at which none does brings nothing down. */
export function movedAtDt({ positions }: TimerProgram): number[] {
  return positions.flatMap((row, servo) => (row.at(-1) === row.at(-2) ? [] : [servo]));
}

/** Whether the tailplane tips up at DT because a servo lets it go then. */
export function isLetGo(program: TimerProgram, uses: readonly ServoUse[]): boolean {
  return movedAtDt(program).some((servo) => uses[servo]?.duty === 'release');
}
