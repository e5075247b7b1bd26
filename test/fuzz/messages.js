// Requests and replies of any timer there can be, with all that their values may be.

import fc from 'fast-check';

/**
 * @typedef {import('../../src/protocol/index.js').Identity} Identity
 * @typedef {import('../../src/protocol/index.js').Request} Request
 * @typedef {import('../../src/protocol/index.js').Reply} Reply
 * @typedef {import('../../src/protocol/index.js').CodecOptions & { identity: Identity }} Options
 */

const MAX_DATA = 252;
/** Mostly as small as real ones, sometimes as large as frames allow. */
const functions = fc.oneof(
  { weight: 8, arbitrary: fc.integer({ min: 1, max: 12 }) },
  fc.integer({ min: 1, max: MAX_DATA / 2 - 1 }),
);

/** @type {fc.Arbitrary<Identity>} */
export const identity = functions.chain((count) =>
  fc.record({
    timerClass: fc.oneof(
      fc.constantFrom('B', 'Q', 'E'),
      fc.integer({ min: 0x21, max: 0x7e }).map((code) => String.fromCharCode(code)),
    ),
    firmware: fc.integer({ min: 0, max: 999 }).map((number) => String(number).padStart(3, '0')),
    functions: fc.constant(count),
    memories: fc.oneof(fc.integer({ min: 1, max: 5 }), fc.integer({ min: 1, max: 255 })),
    servos: fc.oneof(
      { weight: 8, arbitrary: fc.integer({ min: 1, max: Math.min(4, Math.floor(MAX_DATA / (count + 1))) }) },
      fc.integer({ min: 1, max: Math.floor(MAX_DATA / (count + 1)) }),
    ),
  }),
);

const flag = fc.boolean();
/** A timer and in what it departs from the usual reading. @type {fc.Arbitrary<Options>} */
export const options = fc.record({
  identity,
  bareChecksum: flag,
  quirks: fc.record({ bigEndianTimes: flag, servoFirst: flag, memoriesFromOne: flag }),
});

/** @param {Identity} identity */
function times({ functions: count }) {
  const time = fc.oneof(fc.integer({ min: 0, max: 0xffff }), fc.constantFrom(0, 0x45, 0xff, 0x100, 0x4500, 0xffff));
  return fc.array(time, { minLength: count + 1, maxLength: count + 1 });
}

/** @param {number} max */
export const upTo = (max) => fc.oneof({ weight: 4, arbitrary: fc.integer({ min: 0, max }) }, fc.constantFrom(0, max));

/** @param {Options} options @returns {fc.Arbitrary<Request>} */
export function requestFor({ identity: timer }) {
  const { functions: last, servos, memories } = timer;
  /** @type {fc.Arbitrary<Request>[]} */
  const all = [
    fc.record({
      name: fc.constant('SETSERVO'),
      function: upTo(last),
      servo: upTo(servos - 1),
      position: upTo(130),
    }),
    fc.record({ name: fc.constant('SETTIMERS'), times: times(timer) }),
    fc.record({ name: fc.constant('MOVETOFUNC'), function: upTo(last) }),
    fc.record({ name: fc.constant('SETMEMORY'), memory: upTo(memories - 1) }),
    fc.record({ name: fc.constant('SETLOWRPM'), idleThrottle: upTo(255) }),
    fc.record({
      name: fc.constantFrom('GETTIMERS', 'GETSERVOPOS', 'GETSWVER', 'UNLOCK', 'JUMP2', 'GETMEMORY', 'GETLOWRPM'),
    }),
  ];
  return fc.oneof(...all);
}

/** @param {Options} options @returns {fc.Arbitrary<Reply>} */
export function replyFor({ identity: timer, quirks }) {
  const { functions: last, servos, memories } = timer;
  // A timer not known to count from 1 may answer the number of its memories.
  const lastMemory = quirks?.memoriesFromOne ? memories - 1 : memories;
  const row = fc.array(upTo(255), { minLength: last + 1, maxLength: last + 1 });
  /** @type {fc.Arbitrary<Reply>[]} */
  const all = [
    fc.record({ name: fc.constantFrom('GETTIMERS', 'SETTIMERS'), times: times(timer) }),
    fc.record({ name: fc.constant('GETSERVOPOS'), positions: fc.array(row, { minLength: servos, maxLength: servos }) }),
    fc.record({ name: fc.constant('GETSWVER'), identity }),
    fc.record({ name: fc.constant('GETMEMORY'), memory: fc.oneof(upTo(lastMemory), fc.constant(null)) }),
    fc.record({ name: fc.constant('GETLOWRPM'), idleThrottle: upTo(255) }),
    fc.record({ name: fc.constantFrom('SETSERVO', 'MOVETOFUNC', 'UNLOCK', 'JUMP2', 'SETMEMORY', 'SETLOWRPM') }),
  ];
  return fc.oneof(...all);
}
