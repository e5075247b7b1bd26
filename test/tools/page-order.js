// Checks the order of the folders of the page: imports run down the list below, and a feature knows no other feature.
// Checks that components call their models and write none of their signals. Part of `npm run lint`.

import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const page = new URL('../../src/app/', import.meta.url);

/** From top to bottom. The folders of one row do not know each other. */
const ORDER = [
  // The files that lie in src/app itself: the start, the models, the views that are shown.
  ['app'],
  ['shell'],
  [
    'connect',
    'program',
    'bench',
    'memories',
    'recognition',
    'compare',
    'library',
    'flights',
    'print',
    'help',
    'line',
    'settings',
    'settle',
  ],
  // Memories and bench write, too.
  ['write'],
  ['timeline'],
  ['ui'],
  // The program on the screen: where it comes from, what is not finished, and the one place that builds all of it.
  ['work'],
  // What the page keeps: models, programs, flights, backups.
  ['records'],
  // One timer on one wire, and what is known of it.
  ['timer'],
  ['messages'],
  ['storage'],
  ['editing'],
  ['browser'],
];

/** Features that may know another one, with the reason. */
const BRACKETS = new Map([
  ['settle', { may: 'bench', why: 'its steps move the servos and unlock the motor by the bench' }],
  ['program', { may: 'bench', why: 'a row of the table says where the servos stand, and offers to bring them there' }],
]);

/** The rooms of the package that the page may use. Only one file uses the simulator. */
const ROOMS = ['line', 'protocol', 'program', 'client', 'serial'];
const SIMULATED = { file: 'connect/simulated-timer.ts', rooms: ['simulator'] };

/**
 * Finds a written signal of a model: `model.signal.value = ...`. A component's own signal is in a
 * variable.
 */
const WRITTEN = /\b(\w+\.\w+)\.value\s*(?:[-+*/]?=(?![=>])|\+\+|--)/g;

/**
 * Whose values they are, and what may be said of a timer, is asked in one place each. Their own sources are for the
 * folders `work`, `records` and `timer` alone.
 */
const ASKED = [
  { sources: { recognition: 'model' }, ask: 'origin: whose the values are' },
  { sources: { knowledge: 'of|isSent' }, ask: 'standings: what may be said of a timer' },
].flatMap(({ sources, ask }) =>
  Object.entries(sources).map(([model, names]) => ({
    pattern: new RegExp(
      `\\b${model}\\s*\\??\\.\\s*(?:${names})\\b|[{,]\\s*(?:${names})\\b[^{}]*\\}\\s*=\\s*[\\w.#]*\\b${model}\\b`,
      'g',
    ),
    ask,
  })),
);

/**
 * What is wrong with one file of the page: its imports, and the signals that a component writes.
 * @param {string} file from src/app, such as `program/presets.tsx`
 * @param {string} text what stands in it
 * @returns {string[]} a sentence for each
 */
export function breaches(file, text) {
  const written = file.endsWith('.tsx') ? [...text.matchAll(WRITTEN)] : [];
  return [
    ...importBreaches(file, text),
    ...written.map(([, signal]) => `${file} writes ${signal}: a component calls a method of the model`),
    ...(/^(?:work|records|timer)\//.test(file) ? [] : sourcesIn(file, text)),
  ];
}

/**
 * What a file asks of the sources of an answer, in place of the answer.
 * @param {string} file
 * @param {string} text
 * @returns {string[]}
 */
function sourcesIn(file, text) {
  return ASKED.flatMap(({ pattern, ask }) =>
    [...text.matchAll(pattern)].map(([found]) => `${file} asks ${found}: ask session.${ask}`),
  );
}

/**
 * What is wrong with the imports of one file of the page.
 * @param {string} file from src/app, such as `program/presets.tsx`
 * @param {string} text what stands in it
 * @returns {string[]} a sentence for each
 */
function importBreaches(file, text) {
  const [, folder = 'app'] = /^([^/]+)\//.exec(file) ?? [];
  const rank = ORDER.findIndex((row) => row.includes(folder));
  if (rank < 0) return [`${file}: the folder ${folder} is not in the order of the page`];
  return [...text.matchAll(/(?:from|import|import\()\s*'(\.[^']+)'/g)].flatMap(([, path = '']) => {
    const target = new URL(path, `file:///src/app/${file}`).pathname.slice('/src/'.length);
    const [top, next = '', ...rest] = target.split('/');
    if (top !== 'app') {
      const may = file === SIMULATED.file ? [...ROOMS, ...SIMULATED.rooms] : ROOMS;
      if (!may.includes(top ?? '')) return [`${file} imports ${path}: of the page only ${SIMULATED.file} may`];
      return next === 'index.js' ? [] : [`${file} imports ${path}: a room is entered through its index.js`];
    }
    const other = rest.length === 0 ? 'app' : next;
    const otherRank = ORDER.findIndex((row) => row.includes(other));
    if (other === folder || otherRank > rank || BRACKETS.get(folder)?.may === other) return [];
    return [`${file} imports ${path}: app/${folder} may not use app/${other}`];
  });
}

/** What is wrong in all files of the page. */
function breachesOfPage() {
  return readdirSync(page, { recursive: true, encoding: 'utf8' })
    .filter((file) => /\.tsx?$/.test(file))
    .flatMap((file) => breaches(file, readFileSync(new URL(file, page), 'utf8')));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const found = breachesOfPage();
  for (const each of found) console.error(each);
  process.exitCode = found.length > 0 ? 1 : 0;
}
