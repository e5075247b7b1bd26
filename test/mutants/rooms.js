// Which code is changed, and which tests have to see it: those of its own floor, the lowest. Without the long matrices,
// which take minutes for each mutant, and without noise: what they hold is held by the others as well.

import { readdirSync } from 'node:fs';

/** The tests that go with a room, by its name. */
export const ROOMS = {
  protocol: ['test/protocol'],
  program: ['test/program'],
  client: ['test/client'],
};

const LEFT_OUT = /matrix\.test\.ts$|\/noise\.test\.ts$/;

/**
 * @param {keyof typeof ROOMS} room
 * @returns {string[]} with MUTANTS_TESTS in the environment those that fit this pattern: quick, while a test is written
 */
export function testFilesOf(room) {
  const wanted = new RegExp(process.env.MUTANTS_TESTS ?? '');
  return ROOMS[room]
    .flatMap((folder) => readdirSync(folder).map((file) => `${folder}/${file}`))
    .filter((file) => file.endsWith('.test.ts') && !LEFT_OUT.test(file) && wanted.test(file));
}
