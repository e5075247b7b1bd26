import { describe, expect, it } from 'vitest';
import { CLASSES, LAYOUTS, newProgram, USUAL_LAYOUT } from '../../../src/app/editing/new-program.js';
import { checkProgram, requireShape } from '../../../src/program/index.js';
import { requireIdentity } from '../../../src/protocol/index.js';

describe('a new program', () => {
  it.each(CLASSES)(
    'of class %s with usual times is nothing unusual, but for a DT that moves nothing until the pilot says what',
    (timerClass) => {
      const program = newProgram({ timerClass, ...USUAL_LAYOUT, from: 'usual' });
      expect(checkProgram(program).map(({ code }) => code)).toEqual(['dt-moves-nothing']);
    },
  );

  it.each(CLASSES)('of class %s has the shape of every layout, and its functions rise', (timerClass) => {
    for (const functions of LAYOUTS.functions) {
      for (const servos of LAYOUTS.servos) {
        const program = newProgram({ timerClass, functions, servos, from: 'usual' });
        requireIdentity(program.identity);
        requireShape(program);
        expect(checkProgram(program).filter(({ code }) => code.startsWith('time-'))).toEqual([]);
      }
    }
  });

  it('from nothing holds nothing but zeros, and says that its DT is short', () => {
    const program = newProgram({ timerClass: 'B', ...USUAL_LAYOUT, from: 'nothing' });
    expect(new Set([...program.times, ...program.positions.flat()])).toEqual(new Set([0]));
    expect(checkProgram(program).map(({ code }) => code)).toContain('dt-short');
  });
});
