// Changes protocol, program and client line by line and looks whether a test sees it. Every mutant that no test sees
// has to stand in equivalent.json, with the reason why it changes nothing that could be seen; else this fails.
//
//     npm run mutants                              all rooms
//     npm run mutants -- client                    one room
//     npm run mutants -- src/client/wire.ts        one file

import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Stryker } from '@stryker-mutator/core';
import { outcome, unseenText } from './outcome.js';
import { ROOMS } from './rooms.js';

process.chdir(fileURLToPath(new URL('../..', import.meta.url)));

const FOLDER = 'dist/mutants';
const HERE = './test/mutants';
const asked = process.argv.slice(2);

/** @param {string} room */
function filesAsked(room) {
  if (asked.length === 0 || asked.includes(room)) return [`src/${room}/*.ts`, '!src/**/index.ts'];
  return asked.filter((file) => file.startsWith(`src/${room}/`));
}

/** @param {string} room */
async function reportOf(room) {
  const fileName = `${FOLDER}/${room}.json`;
  rmSync(fileName, { force: true });
  process.env.MUTANTS_ROOM = room;
  await new Stryker({
    testRunner: 'room',
    plugins: [`${HERE}/runner.js`, `${HERE}/prose.js`],
    ignorers: ['prose'],
    mutate: filesAsked(room),
    coverageAnalysis: 'perTest',
    tsconfigFile: 'none',
    reporters: ['json', 'html'],
    jsonReporter: { fileName },
    htmlReporter: { fileName: `${FOLDER}/${room}.html` },
    tempDirName: `${FOLDER}/work`,
    ignorePatterns: ['dist', 'examples', 'test/app', 'test/site', 'test/rig', 'test/bench', 'test/tools/pinned'],
    // Beside what its tests take: a machine may be busy, and an endless loop is mostly found by counting.
    timeoutMS: 10_000,
    warnings: { slow: false },
  }).runMutationTest();
  return JSON.parse(readFileSync(fileName, 'utf8'));
}

mkdirSync(FOLDER, { recursive: true });
const equivalent = JSON.parse(readFileSync(`${HERE}/equivalent.json`, 'utf8'));
const rows = [];
let text = '';
for (const room of Object.keys(ROOMS)) {
  if (filesAsked(room).length === 0) continue;
  const found = outcome(await reportOf(room), equivalent);
  rows.push(
    `${room}: ${Object.entries(found.counts)
      .map(([what, count]) => `${count} ${what}`)
      .join(', ')}`,
  );
  text += unseenText(found);
  if (found.unseen.length > 0 || found.stale.length > 0) process.exitCode = 1;
}
process.stdout.write(`\n${rows.join('\n')}\n${text}`);
