// What judges a change tries the same cases each time: a new seed could refuse a change for a fault that is older than
// it. Elsewhere each run has a new seed, and so has the nightly workflow: `npm run test:unit` without CI set.

import { env } from 'node:process';
import fc from 'fast-check';

const { CI } = env;
if (CI) fc.configureGlobal({ ...fc.readConfigureGlobal(), seed: 1 });
