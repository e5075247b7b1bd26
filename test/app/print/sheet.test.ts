import { describe, expect, it } from 'vitest';
import { type SheetSource, sheetOf } from '../../../src/app/print/sheet.js';
import { servoGroups } from '../../../src/app/print/sheet-paper.js';
import type { TimerProgram } from '../../../src/program/index.js';
import { MODEL, SETTING } from '../../program/library-examples.js';
import { en } from '../../tools/en.js';
import { programOf } from '../programs.js';

const sourceOf = (program: TimerProgram, changes: Partial<SheetSource> = {}): SheetSource => ({
  key: 'one',
  program,
  model: MODEL,
  name: SETTING.name,
  note: SETTING.note,
  origin: 'Typed',
  simulated: false,
  link: null,
  ...changes,
});
describe('a setting sheet', () => {
  it('names model, memory, timer, and gives DT and motor stop', () => {
    const sheet = sheetOf(sourceOf(SETTING.program));
    expect(sheet).toMatchObject({
      model: 'Lancer 07',
      name: 'calm morning',
      timer: 'F1Q, firmware\u00a0536, 3\u00a0functions, 2\u00a0servos',
      memory: 'M2',
      servos: ['Tailplane', 'flaps'],
      note: ['Turns left after 12 s.'],
      others: [{ label: en.program.idleThrottle, text: '12' }],
    });
    expect(sheet.figures.map(({ label, text, isShort }) => [label, text, isShort])).toEqual([
      ['DT', '3:00 min', false],
      ['motor stop', '10.0 s', false],
    ]);
    expect(sheetOf(sourceOf({ ...SETTING.program, memory: 2 })).memory).toBe('M3 “fly-off”');
    expect(sheetOf(sourceOf(SETTING.program, { model: null }))).toMatchObject({
      model: '',
      servos: ['', ''],
      memory: 'M2',
    });
  });

  it('says what may cost a model, and a DT that is short', () => {
    const short = sheetOf(sourceOf({ ...SETTING.program, times: [3000, 30, 1050, 1300, 2000] }));
    expect(short.figures[0]).toMatchObject({ text: '20 s', isShort: true });
    expect(short.warnings.join()).toMatch(/Motor stop: The motor stops after DT/);
    expect(sheetOf(sourceOf(SETTING.program)).warnings).toEqual([]);
    expect(
      sheetOf(sourceOf({ ...SETTING.program, times: [1000, 30, 1050, 1300, 7000] }), 9000).figures[0]?.isShort,
    ).toBe(true);
  });

  it('loses nothing: a time without a meaning on its class stands beside the table', () => {
    const program = programOf('B', [1234, 300, 18_000], [[1, 2, 3]]);
    expect(sheetOf(sourceOf(program)).others).toEqual([{ label: 'Start time', text: 'reserved 12.34 s' }]);
  });

  it.each([
    [1, [1]],
    [8, [8]],
    [9, [5, 4]],
    [17, [6, 6, 5]],
  ])('%i servos stand in tables of about equal width', (servos, widths) => {
    const groups = servoGroups(servos);
    expect(groups.map(({ length }) => length)).toEqual(widths);
    expect(groups.flat()).toEqual(Array.from({ length: servos }, (_, servo) => servo));
  });
});
