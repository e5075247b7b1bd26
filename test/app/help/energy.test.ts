import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  type Allowance,
  allowanceFor,
  ENERGY_RULES,
  type EnergyRule,
  energyOf,
  figureIn,
} from '../../../src/app/help/energy.js';

const { rounds, flyOff } = ENERGY_RULES;

describe('the energy that the rules of F1Q leave', () => {
  type Row = readonly [EnergyRule, number, number, number, Allowance['energyBy'], number, Allowance['runBy']];
  const rows: readonly Row[] = [
    // weight in g, power in W, joules, run in hundredths
    [rounds, 480, 165, 1440, 'weight', 870, 'energy'],
    [rounds, 500, 150, 1500, 'weight', 1000, 'energy'],
    [rounds, 550, 165, 1650, 'weight', 1000, 'energy'],
    [rounds, 551, 165, 1650, 'ceiling', 1000, 'energy'],
    [rounds, 480, 36, 1440, 'weight', 4000, 'energy'],
    [rounds, 480, 35.9, 1440, 'weight', 4000, 'time'],
    [flyOff, 480, 165, 960, 'weight', 580, 'energy'],
    [flyOff, 480, 40, 960, 'weight', 2000, 'time'],
    // As a sum of fractions it is a hair too little.
    [rounds, 103, 20.6, 309, 'weight', 1500, 'energy'],
  ];
  it.each(rows)('%o: %f g at %f W may have %i J (by %s), and run for %i hundredths (ended by %s)', (...row) => {
    const [rule, weight, power, energy, energyBy, run, runBy] = row;
    expect(allowanceFor(rule, weight, power)).toEqual({ energy, energyBy, run, runBy });
  });

  it('gives the longest run that stays within it: a tenth of a second more is too much', () => {
    const weight = fc.double({ min: 10, max: 5000, noNaN: true });
    const power = fc.double({ min: 1, max: 5000, noNaN: true });
    fc.assert(
      fc.property(fc.constantFrom(rounds, flyOff), weight, power, (rule, grams, watts) => {
        const { run } = allowanceFor(rule, grams, watts);
        const energy = Math.min(rule.perGram * grams, rule.most);
        const fits = (seconds: number): boolean => seconds <= rule.longest && seconds * watts <= energy * (1 + 1e-6);
        expect(run % 10).toBe(0);
        expect([fits(run / 100), fits(run / 100 + 0.1001)]).toEqual([true, false]);
      }),
    );
  });

  it('is the energy of a motor run, rounded up', () => {
    expect([energyOf(1000, 150), energyOf(870, 165), energyOf(0, 165)]).toEqual([1500, 1436, 0]);
  });
});

describe('a typed figure', () => {
  it.each([
    ['450', 450],
    [' 11,1 ', 11.1],
    ['11.125', 11.125],
    ['', null],
    ['-3', null],
    ['1e3', null],
    ['4 50', null],
    ['9', null],
    ['5001', null],
    ['1.2.3', null],
    ['0x20', null],
  ])('“%s” is %s', (text, value) => {
    expect(figureIn(text, 10, 5000)).toBe(value);
  });
});
