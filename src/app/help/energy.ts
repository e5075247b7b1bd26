import { plainDigits } from '../editing/units.js';

/** What the rules of class F1Q allow the motor, as far as they are known. */
export interface EnergyRule {
  /** Joules for each gram of the model. */
  readonly perGram: number;
  /** The most joules, whatever the weight. */
  readonly most: number;
  /** The longest motor run in seconds, however little energy it takes. */
  readonly longest: number;
}

/**
 * As pilots told the rules of F1Q around 2022. Nobody has compared them with the Sporting Code of the FAI, which may
 * have changed since; the page says so. The figures for a fly-off were less certain even then, and nobody named another
 * ceiling for it.
 */
export const ENERGY_RULES = {
  toldIn: 2022,
  rounds: { perGram: 3, most: 1650, longest: 40 },
  flyOff: { perGram: 2, most: 1650, longest: 20 },
} as const satisfies { toldIn: number } & Record<'rounds' | 'flyOff', EnergyRule>;

export type EnergyEvent = 'rounds' | 'flyOff';

/** The motor run that a rule allows. */
export interface Allowance {
  /** Joules, rounded down. */
  readonly energy: number;
  /** Which of the two limits the energy. */
  readonly energyBy: 'weight' | 'ceiling';
  /** Hundredths of a second, rounded down to the whole tenths that the timer takes. */
  readonly run: number;
  /** What ends the run: the energy, or the longest time. */
  readonly runBy: 'energy' | 'time';
}

/** @param weight in grams. @param power that the motor takes from its battery, in watts. Both above 0. */
export function allowanceFor({ perGram, most, longest }: EnergyRule, weight: number, power: number): Allowance {
  const byWeight = perGram * weight;
  const energy = Math.min(byWeight, most);
  const seconds = Math.min(energy / power, longest);
  return {
    energy: floor(energy),
    energyBy: byWeight <= most ? 'weight' : 'ceiling',
    run: 10 * floor(10 * seconds),
    runBy: energy / power <= longest ? 'energy' : 'time',
  };
}

/** The energy of a motor run in joules, rounded up. @param run in hundredths of a second. */
export function energyOf(run: number, power: number): number {
  return Math.max(0, Math.ceil((run * power) / 100 - TINY));
}

/** The rounding error that a sum of fractions may have. */
const TINY = 1e-6;

function floor(value: number): number {
  return Math.floor(value + TINY);
}

/**
 * Reads a typed figure: “450”, “11.1”, “11,1”.
 * @returns null when it is no number, or not from `least` to `most`.
 */
export function figureIn(text: string, least: number, most: number): number | null {
  const typed = plainDigits(text).replace(',', '.');
  if (!/^\d{1,6}(\.\d{1,3})?$/.test(typed)) return null;
  const value = Number(typed);
  return value >= least && value <= most ? value : null;
}
