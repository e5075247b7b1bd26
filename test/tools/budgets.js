// Holds the size of the code: lines for each folder of src and for all tests, sentences for each group of en.ftl. The
// ceilings stand in budgets.json. Part of `npm run lint`, which prints the sums. A commit that removes something lowers
// the ceilings with `npm run lint:lower`. To raise one, edit the file by hand and say why in the commit.

import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const root = new URL('../../', import.meta.url);
const budgets = new URL('budgets.json', import.meta.url);
const MESSAGES = 'src/app/messages';
/** As long as en.ftl wants them: what is made of it, and its translations. */
const FOLLOWS = new RegExp(`^(?:src/app/first-picture\\.json|${MESSAGES}/(?:sentences\\.ts|(?!en\\.)[\\w-]+\\.ftl))$`);

/**
 * @typedef {object} Figures
 * @property {Record<string, number>} lines of each folder of src
 * @property {number} styles lines of all of them
 * @property {number} tests lines of all of them
 * @property {Record<string, number>} sentences of each group
 */

/** All files of a folder, from the root of the project. @param {string} folder */
function filesIn(folder) {
  return readdirSync(new URL(folder, root), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && !/node_modules|\.tsbuildinfo$/.test(`${entry.parentPath}/${entry.name}`))
    .map((entry) => `${entry.parentPath}/${entry.name}`.slice(fileURLToPath(root).length))
    .filter((file) => !FOLLOWS.test(file));
}

/** @param {string} file */
function linesOf(file) {
  return readFileSync(new URL(file, root), 'utf8').split('\n').length - 1;
}

/** The folder that a file counts for: a room of the package, or a folder of the page. @param {string} file */
function roomOf(file) {
  const [, room = 'src'] = /^(src\/app\/[^/]+|src\/[^/]+)\/./.exec(file) ?? [];
  return room;
}

/** How many sentences each group has. Those of no group count as `alone`. @param {string} text of en.ftl */
export function sentencesIn(text) {
  /** @type {Record<string, number>} */
  const groups = {};
  for (const [, group = ''] of text.matchAll(/^(?:([A-Za-z]+)_)?[\w-]+ =/gm)) {
    const name = group || 'alone';
    groups[name] = (groups[name] ?? 0) + 1;
  }
  return sorted(groups);
}

/** @param {readonly number[]} figures */
function sum(figures) {
  return figures.reduce((all, each) => all + each, 0);
}

/** The figures of today. @returns {Figures} */
export function measured() {
  /** @type {Record<string, number>} */
  const lines = {};
  for (const file of filesIn('src')) lines[roomOf(file)] = (lines[roomOf(file)] ?? 0) + linesOf(file);
  return {
    lines: sorted(lines),
    styles: sum(
      filesIn('src')
        .filter((file) => file.endsWith('.css'))
        .map(linesOf),
    ),
    tests: sum(
      filesIn('test')
        .filter((file) => /\.(?:tsx?|m?js)$/.test(file))
        .map(linesOf),
    ),
    sentences: sentencesIn(readFileSync(new URL(`${MESSAGES}/en.ftl`, root), 'utf8')),
  };
}

/** @param {Record<string, number>} record */
function sorted(record) {
  return Object.fromEntries(Object.entries(record).sort(([a], [b]) => (a < b ? -1 : 1)));
}

/** Each figure by its name: `lines of src/client`. @param {Figures} figures @returns {Map<string, number>} */
function named({ lines, sentences, ...others }) {
  /** @type {(of: string) => (entry: [string, number]) => [string, number]} */
  const of =
    (what) =>
    ([name, figure]) => [`${what} of ${name}`, figure];
  return new Map([
    ...Object.entries(lines).map(of('lines')),
    ...Object.entries(sentences).map(of('sentences')),
    ...Object.entries(others).map(of('lines')),
  ]);
}

/**
 * What is larger than it may be. A folder or group without a ceiling may not be there.
 * @param {Figures} now
 * @param {Figures} ceilings
 * @returns {string[]} a sentence for each
 */
export function overruns(now, ceilings) {
  const may = named(ceilings);
  return [...named(now)].flatMap(([name, figure]) => {
    const most = may.get(name) ?? 0;
    return figure > most ? [`${name}: ${figure}, at most ${most} (test/tools/budgets.json)`] : [];
  });
}

/**
 * The ceilings for a project that has become smaller: none is higher than before.
 * @param {Figures} now
 * @param {Figures} ceilings
 * @returns {Figures}
 */
export function lowered(now, ceilings) {
  /** @type {(figures: Record<string, number>, most: Record<string, number>) => Record<string, number>} */
  const least = (figures, most) =>
    Object.fromEntries(Object.entries(figures).map(([name, figure]) => [name, Math.min(figure, most[name] ?? 0)]));
  return {
    lines: least(now.lines, ceilings.lines),
    styles: Math.min(now.styles, ceilings.styles),
    tests: Math.min(now.tests, ceilings.tests),
    sentences: least(now.sentences, ceilings.sentences),
  };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const now = measured();
  const ceilings = JSON.parse(readFileSync(budgets, 'utf8'));
  const total = (/** @type {Record<string, number>} */ record) => sum(Object.values(record));
  console.log(
    `src ${total(now.lines)} lines (styles ${now.styles}), tests ${now.tests}, sentences ${total(now.sentences)}`,
  );
  const found = overruns(now, ceilings);
  for (const each of found) console.error(each);
  process.exitCode = found.length > 0 ? 1 : 0;
  if (process.argv.includes('--lower')) {
    writeFileSync(budgets, `${JSON.stringify(lowered(now, ceilings), null, 2)}\n`);
  }
}
