import { effect } from '@preact/signals';
import type { EntryCounts, Records } from '../../../src/app/library/files/import-plan.js';
import type { LibraryFiles } from '../../../src/app/library/files/library-files.js';
import type { TimerProgram } from '../../../src/program/index.js';

const NAMES = ['Lancer', 'Pelican', 'Old Faithful', 'Magpie', 'Swift', 'Heron', 'Kestrel', 'Müller'];
const WORDS = ['fly-off', 'calm', 'wind', 'trimming', 'morning', 'slope', 'spare wing', 'thermal'];
const NOTE = 'Tailplane two steps down since October; opens well in 3 m/s too. ';
const DAY = 86_400_000;
const CLASSES = ['Q', 'B', 'E'] as const;

/** A library of a pilot who has kept everything for years: the same one for the same counts. */
export function manyRecords({ models, settings, flights }: EntryCounts): Records {
  const pick = <T>(from: readonly T[], at: number): T => from[at % from.length] as T;
  return {
    models: Array.from({ length: models }, (_, at) => {
      const key = `model-${at}`;
      const model = {
        id: key,
        name: `${pick(NAMES, at)} ${String(at + 1).padStart(2, '0')}`,
        timerClass: pick(CLASSES, at),
        note: NOTE.repeat(at % 4),
        servos: [],
        memoryNames: ['calm', 'fly-off'],
        archived: at % 9 === 8,
      };
      return { key, changedAt: DAY * at, verified: [], model };
    }),
    settings: Array.from({ length: settings }, (_, at) => {
      const key = `setting-${at}`;
      const setting = {
        id: key,
        model: at % 50 === 49 ? null : `model-${at % models}`,
        name: `${pick(WORDS, at)} ${at}`,
        note: NOTE.repeat(at % 5),
        tags: [pick(WORDS, at + 3), `series ${at % 17}`],
        at: DAY * (18_000 + (at % 2000)),
        program: programAt(at, pick(CLASSES, at % models)),
        from: 'timer' as const,
        archived: at % 20 === 19,
      };
      return { key, changedAt: DAY * at, setting };
    }),
    flights: Array.from({ length: flights }, (_, at) => {
      const key = `flight-${at}`;
      const flight = {
        id: key,
        at: DAY * 18_000 + at * 3_600_000,
        place: pick(['Turda', 'Moncontour', 'Zülpich', 'Thouars'], at),
        model: `model-${at % models}`,
        modelName: pick(NAMES, at % models),
        setting: settings === 0 ? null : `setting-${at % settings}`,
        settingName: pick(WORDS, at),
        program: programAt(at, 'Q'),
        wind: at % 7,
        temperature: 10 + (at % 20),
        round: String((at % 7) + 1),
        result: 120 + (at % 61),
        note: at % 3 === 0 ? NOTE : '',
      };
      return { key, changedAt: DAY * at, flight };
    }),
  };
}

function programAt(at: number, timerClass: string): TimerProgram {
  const identity = { timerClass, firmware: '536', functions: 10, memories: 4, servos: 3 };
  return {
    identity,
    memory: at % 4,
    times: [timerClass === 'Q' ? 1000 : 0, 30, 100, 300, 600, 970, 1000, 1030, 1100, 1250, 18_000 + (at % 5) * 600],
    positions: [0, 1, 2].map((servo) => Array.from({ length: 11 }, (_, slot) => (at + servo * 31 + slot * 7) % 131)),
    idleThrottle: timerClass === 'Q' ? 20 : null,
  };
}

/** Imports a file, as a pilot who keeps what is newer. */
export async function importNewer(files: LibraryFiles, text: string): Promise<void> {
  const importing = files.import([new File([text], 'a.sidus')]);
  const answer = await new Promise<(way: 'newer') => void>((resolve) => {
    effect(() => {
      if (files.asked.value && files.asked.value.shown !== 'reading') resolve(files.asked.value.answer);
    });
  });
  answer('newer');
  await importing;
}
