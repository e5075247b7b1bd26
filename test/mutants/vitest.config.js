import { defineConfig } from 'vitest/config';

// The tests of the rooms that are mutated, without the long matrices: those take minutes for each mutant, and what they
// hold is held by the others as well.
export default defineConfig({
  test: {
    testTimeout: 120_000,
    include: ['test/protocol/*.test.ts', 'test/program/*.test.ts', 'test/client/*.test.ts', 'test/line/*.test.ts'],
    exclude: ['test/client/matrix.test.ts', 'test/client/memories.test.ts', 'test/protocol/cost.test.ts'],
  },
});
