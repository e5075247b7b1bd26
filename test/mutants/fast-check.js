// fast-check for the run of mutants: always the same cases, few of them, and no search for the smallest one that fails.
// A mutant is seen by the same test each night, and quickly.

import real from '../../node_modules/fast-check/lib/fast-check.js';

const RUNS = 20;

const limited = (params) => ({
  ...params,
  seed: 1,
  numRuns: Math.min(params?.numRuns ?? RUNS, RUNS),
  endOnFailure: true,
});

export default { ...real, assert: (property, params) => real.assert(property, limited(params)) };
