// What the tests of the rooms use of Vitest, without Vitest: they are gathered once, and then run one by one in this
// process. Anything else of Vitest that a test uses fails at once, as it is not there.

import { format } from 'node:util';
import {
  ASYMMETRIC_MATCHERS_OBJECT,
  chai,
  JestAsymmetricMatchers,
  JestChaiExpect,
  JestExtend,
} from '../../node_modules/@vitest/expect/dist/index.js';
import { fn } from '../../node_modules/@vitest/spy/dist/index.js';

chai.use(JestExtend);
chai.use(JestChaiExpect);
chai.use(JestAsymmetricMatchers);

const expect = Object.assign((value, message) => chai.expect(value, message), chai.expect, {
  ...globalThis[ASYMMETRIC_MATCHERS_OBJECT],
  unreachable: (message) => chai.assert.fail(`reached what must not be reached: ${message}`),
});

/** Types are held by the compiler. */
const expectTypeOf = () => new Proxy(() => {}, { get: expectTypeOf, apply: expectTypeOf });

const stubbed = new Map();
const vi = {
  fn,
  stubGlobal(name, value) {
    if (!stubbed.has(name)) stubbed.set(name, Object.getOwnPropertyDescriptor(globalThis, name));
    Object.defineProperty(globalThis, name, { value, configurable: true, writable: true });
  },
  unstubAllGlobals() {
    for (const [name, own] of stubbed) {
      if (own) Object.defineProperty(globalThis, name, own);
      else delete globalThis[name];
    }
    stubbed.clear();
  },
};

const root = () => ({ path: [], before: [], after: [] });
let suite = root();
let tests = [];

/**
 * The tests of one file.
 * @param {() => Promise<unknown>} load loads it
 */
export async function gathered(load) {
  suite = root();
  tests = [];
  await load();
  return tests;
}

const each = (add) => (rows) => (name, body) => {
  for (const row of rows) {
    const values = Array.isArray(row) ? row : [row];
    const shown = values.slice(0, name.match(/%[sidfjo]/g)?.length ?? 0).map(String);
    add(format(name, ...shown), () => body(...values));
  }
};

function it(name, body) {
  const { path, before, after } = suite;
  const run = async () => {
    try {
      for (const hook of before) await hook();
      await body();
    } finally {
      for (const hook of after) await hook();
    }
  };
  tests.push({ name: [...path, name].join(' > '), run });
}
it.each = each(it);

function describe(name, body) {
  const outer = suite;
  suite = { path: [...outer.path, name], before: [...outer.before], after: [...outer.after] };
  body();
  suite = outer;
}
describe.each = each(describe);

export const api = {
  describe,
  it,
  test: it,
  beforeEach: (hook) => void suite.before.push(hook),
  afterEach: (hook) => void suite.after.push(hook),
  expect,
  expectTypeOf,
  vi,
};
