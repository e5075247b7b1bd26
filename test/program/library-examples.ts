import type { Flight, Model, Setting, SettingVersion, TimerProgram } from '../../src/program/index.js';

const PROGRAM: TimerProgram = {
  identity: { timerClass: 'Q', firmware: '536', functions: 4, memories: 4, servos: 2 },
  memory: 1,
  times: [1000, 30, 1050, 1300, 18000],
  positions: [
    [15, 25, 40, 55, 115],
    [15, 15, 60, 70, 115],
  ],
  idleThrottle: 12,
};

/** One of each thing that a pilot keeps, with every field filled. */
export const MODEL: Model = {
  id: 'lancer-07',
  name: 'Lancer 07',
  timerClass: 'Q',
  note: 'New wing in March.\nCG at 54 %.',
  servos: [
    { duty: 'tailplane', name: '', low: 20, high: 95, reversed: true },
    { duty: 'other', name: 'flaps', low: 0, high: 130, reversed: false },
  ],
  memoryNames: ['calm', '', 'fly-off'],
  archived: false,
};

export const SETTING: Setting = {
  id: 'calm-morning',
  model: MODEL.id,
  name: 'calm morning',
  note: 'Turns left after 12 s.',
  tags: ['calm', 'contest'],
  at: 1_795_000_000_000,
  program: PROGRAM,
  from: 'timer',
  archived: false,
};

/** What it held before: DT was half a minute longer. */
export const VERSION: SettingVersion = {
  until: 1_794_999_000_000,
  at: 1_794_900_000_000,
  program: { ...PROGRAM, times: PROGRAM.times.with(4, 21_000) },
  from: 'typed',
};

export const FLIGHT: Flight = {
  id: 'flight-1',
  at: 1_795_000_500_000,
  place: 'Manching',
  model: MODEL.id,
  modelName: MODEL.name,
  setting: SETTING.id,
  settingName: SETTING.name,
  program: PROGRAM,
  wind: 1.5,
  temperature: -3,
  round: 'fly-off 1',
  result: 341.5,
  note: 'Late DT.',
};
