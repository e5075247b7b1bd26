import { describe, expect, it } from 'vitest';
import type { TimerError, TimerErrorCode } from '../../src/client/errors.js';
import { Exchange } from '../../src/client/exchange.js';
import { LearnedTiming } from '../../src/client/line-timing.js';
import { Quirks } from '../../src/client/quirks.js';
import { longestExchange, longestFence } from '../../src/client/retry-policy.js';
import { Wire } from '../../src/client/wire.js';
import { VirtualClock } from '../../src/line/index.js';
import { encodeFrame, encodeReply, FrameDecoder, type Identity, type Reply } from '../../src/protocol/index.js';

const identity: Identity = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };
const said = (reply: Reply): Uint8Array => encodeReply(reply, { identity });
const version = (firmware: string): Uint8Array => said({ name: 'GETSWVER', identity: { ...identity, firmware } });
const GETSWVER = 0x6b;
const GETMEMORY = 0x71;
const MOVETOFUNC = 0x69;
const NOISE = Uint8Array.of(1, 2);
/** What cannot be as a reply to any request. */
const bad = (code: number): Uint8Array => encodeFrame(code + 1, [1, 2, 3, 4]);

/** What a timer says to each request. */
const ANSWERS = new Map<number, Uint8Array>([
  [GETSWVER, version('536')],
  [GETMEMORY, said({ name: 'GETMEMORY', memory: 2 })],
  [MOVETOFUNC, said({ name: 'MOVETOFUNC' })],
]);

type Comes = 'ok' | 'silent' | 'noise' | 'bad';
/** What comes, in this order, and the last of it from then on. */
const inTurn = (...comes: readonly Comes[]) => {
  let count = 0;
  return (): Comes => comes[Math.min(count++, comes.length - 1)] as Comes;
};

/** One byte takes one millisecond, and a reply may take 600 more. */
const TIMING = { baudRate: 10_000, margin: 600 };

/** An exchange of which a test is the other end. */
function setUp() {
  const clock = new VirtualClock(1000);
  const timing = new LearnedTiming(TIMING);
  let controller: ReadableStreamDefaultController<Uint8Array> | undefined;
  const requests = new FrameDecoder();
  const sent: { code: number; at: number }[] = [];
  const bench = {
    clock,
    sent,
    codes: () => sent.map(({ code }) => code),
    /** What comes back to a request, or the bytes that do. */
    comes: (_code: number): Comes | Uint8Array => 'ok',
    run: <T>(promise: Promise<T>) => clock.run(promise),
  };
  const answer = (code: number): Uint8Array | undefined => {
    const what = bench.comes(code);
    if (typeof what !== 'string') return what;
    return { ok: ANSWERS.get(code), silent: undefined, noise: NOISE, bad: bad(code) }[what];
  };
  const port = {
    readable: new ReadableStream<Uint8Array>({
      start: (own) => {
        controller = own;
      },
    }),
    writable: new WritableStream<Uint8Array>({
      write: (bytes) => {
        for (const { code } of requests.push(bytes)) {
          sent.push({ code, at: clock.now() });
          const reply = answer(code);
          if (reply) controller?.enqueue(reply);
        }
      },
    }),
  };
  const wire = new Wire(port, new Quirks({}), { timing, clock, onLine: undefined, onLost: undefined });
  const exchange = new Exchange(wire, clock, timing);
  exchange.identity = identity;
  return Object.assign(bench, { wire, exchange, timing });
}

/** One to which a request that is not repeated stays unanswered, when a timer has answered before. */
async function unanswered() {
  const bench = setUp();
  await bench.run(bench.exchange.ask({ name: 'GETMEMORY' }));
  bench.comes = () => 'silent';
  await bench.run(bench.exchange.ask({ name: 'UNLOCK' }).catch(() => {}));
  bench.comes = () => 'ok';
  bench.sent.length = 0;
  return bench;
}

/** What is thrown. */
const failureOf = (promise: Promise<unknown>): Promise<TimerError> =>
  promise.then(
    () => expect.unreachable('it does not fail'),
    (error: TimerError) => error,
  );

describe('a request that is given up', () => {
  const CANNOT = 'the reply to GETMEMORY cannot be right';
  const DAMAGE = 'too much damage to get a reply to GETMEMORY';
  const NONE = 'no reply to GETMEMORY';

  it.each<[string, Comes[], Comes[], TimerErrorCode, string, number]>([
    ['three impossible replies', ['bad'], ['ok'], 'bad-reply', CANNOT, 3],
    ['three impossible replies after silence', ['silent', 'bad'], ['ok'], 'bad-reply', CANNOT, 4],
    ['two impossible replies, and noise', ['bad', 'bad', 'noise'], ['ok'], 'unstable', DAMAGE, 20],
    ['noise', ['noise'], ['ok'], 'unstable', DAMAGE, 20],
    ['silence, while others are answered', ['silent'], ['ok'], 'no-answer', NONE, 10],
    ['silence, while others are damaged', ['silent'], ['noise', 'ok'], 'no-answer', NONE, 20],
    ['noise, then silence to every request', ['noise', 'silent'], ['silent'], 'no-answer', NONE, 2],
  ])('for %s', async (_, own, others, code, message, sent) => {
    const bench = setUp();
    await bench.run(bench.exchange.ask({ name: 'GETMEMORY' }));
    const [ownComes, othersCome] = [inTurn(...own), inTurn(...others)];
    bench.comes = (asked) => (asked === GETMEMORY ? ownComes() : othersCome());
    expect(await bench.run(failureOf(bench.exchange.ask({ name: 'GETMEMORY' })))).toMatchObject({
      code,
      message,
      details: { request: 'GETMEMORY', sent },
    });
  });

  it.each<[Comes, TimerErrorCode]>([
    ['silent', 'no-answer'],
    // It may have been carried out: what came damaged may be its acknowledgement.
    ['noise', 'no-answer'],
    ['bad', 'bad-reply'],
  ])('because it must not be repeated: %s', async (comes, code) => {
    const bench = setUp();
    bench.comes = () => comes;
    const failure = await bench.run(failureOf(bench.exchange.ask({ name: 'MOVETOFUNC', function: 3 })));
    expect(failure).toMatchObject({ code, details: { request: 'MOVETOFUNC', sent: 1 } });
    expect(bench.codes()).toEqual([MOVETOFUNC]);
  });

  it('before it goes out, because its time is up and the fence was damaged', async () => {
    const bench = await unanswered();
    bench.exchange.begin({ parts: [] });
    const { endsBy } = bench.exchange.schedule;
    const needed = longestFence(TIMING) + longestExchange('JUMP2', identity, TIMING);
    bench.comes = () => 'noise';
    await bench.clock.advance(endsBy - needed - bench.clock.now() - 618);
    await bench.run(failureOf(bench.exchange.ask({ name: 'UNLOCK' })));
    bench.sent.length = 0;
    const failure = await bench.run(failureOf(bench.exchange.ask({ name: 'JUMP2' })));
    expect(failure).toMatchObject({ code: 'unstable', details: { request: 'JUMP2', sent: 0 } });
    expect(bench.codes()).toEqual([GETSWVER]);
  });

  it('at once after twelve exchanges without an answer, unless the last ones were silent', async () => {
    const bench = setUp();
    await bench.run(bench.exchange.ask({ name: 'GETMEMORY' }));
    bench.sent.length = 0;
    bench.comes = inTurn(...Array<Comes>(11).fill('noise'), 'silent');
    await bench.run(failureOf(bench.exchange.ask({ name: 'GETMEMORY' })));
    expect(bench.sent).toHaveLength(12);
    expect(bench.clock.now() - (bench.sent.at(-1)?.at ?? 0)).toBeLessThan(700);
  });

  it.each<[boolean, number]>([
    [true, 7],
    [false, 7],
  ])('for silence after noise after seven exchanges, whether it has answered before: %s', async (before, silent) => {
    const bench = setUp();
    if (before) await bench.run(bench.exchange.ask({ name: 'GETMEMORY' }));
    bench.sent.length = 0;
    bench.comes = inTurn('noise', 'silent');
    await bench.run(failureOf(bench.exchange.ask({ name: 'GETMEMORY' })));
    expect(bench.sent).toHaveLength(1 + silent);
  });
});

const own = longestExchange('GETMEMORY', identity, TIMING);

it.each<[string, boolean, number]>([
  ['the request', false, own],
  ['a fence and the request', true, longestFence(TIMING) + own],
])('the time of a job must be enough for %s', async (_, isFenced, needed) => {
  for (const missing of [0, 1]) {
    const bench = setUp();
    bench.exchange.begin({ parts: [] });
    const begin = bench.exchange.schedule.endsBy - needed + missing;
    const fenced = { code: 0x6d, waitsFor: 9 + 9 + 600 };
    await bench.clock.advance(begin - bench.clock.now() - (isFenced ? fenced.waitsFor : 0));
    bench.comes = (code) => (code === fenced.code ? 'silent' : 'ok');
    if (isFenced) await bench.run(failureOf(bench.exchange.ask({ name: 'UNLOCK' })));
    expect(bench.clock.now()).toBe(begin);
    bench.sent.length = 0;
    const asked = bench.exchange.ask({ name: 'GETMEMORY' });
    if (missing === 0) expect(await bench.run(asked)).toMatchObject({ memory: 2 });
    else {
      expect(await bench.run(failureOf(asked))).toMatchObject({ code: 'no-answer', details: { sent: 0 } });
      expect(bench.sent).toEqual([]);
    }
  }
});

describe('a fence', () => {
  it('goes out before a request while an older one can still be answered, and not later', async () => {
    for (const [since, codes] of [
      [2999, [GETSWVER, GETMEMORY]],
      [3000, [GETMEMORY]],
    ] as const) {
      const bench = setUp();
      bench.comes = () => 'silent';
      const begin = bench.clock.now();
      await bench.run(failureOf(bench.exchange.ask({ name: 'UNLOCK' })));
      bench.comes = () => 'ok';
      bench.sent.length = 0;
      await bench.clock.advance(begin + since - bench.clock.now());
      const checks: number[] = [];
      const beforeRepeat = async () => void checks.push(bench.clock.now());
      await bench.run(bench.exchange.ask({ name: 'GETMEMORY' }, undefined, { beforeRepeat }));
      expect(bench.codes()).toEqual(codes);
      expect(checks).toEqual([]);
    }
  });

  it('is not needed where a late reply to the same question is good enough', async () => {
    const bench = setUp();
    const comes = inTurn('silent', 'ok');
    bench.comes = comes;
    await bench.run(bench.exchange.identify(undefined, { anyReply: true }));
    expect(bench.codes()).toEqual([GETSWVER, GETSWVER]);
    const other = await unanswered();
    await other.run(other.exchange.identify(undefined, { anyReply: true }));
    expect(other.codes(), 'after another question a fence goes out first').toEqual([GETSWVER, GETSWVER]);
  });

  it('does not stop a question about what is there now when another timer answers it', async () => {
    const bench = await unanswered();
    bench.comes = (code) => (code === GETSWVER ? version('999') : 'ok');
    expect(await bench.run(bench.exchange.identify())).toMatchObject({ identity: { firmware: '999' } });
    expect(bench.exchange.identity?.firmware).toBe('999');
  });
});

describe('a check before a request goes out again', () => {
  it.each<[string, Comes[], Comes[], number]>([
    ['is not made before the first time', ['ok'], ['ok'], 0],
    ['is not made after damage: the timer was there', ['noise', 'noise', 'ok'], ['ok'], 0],
    ['is made after silence', ['silent', 'silent', 'ok'], ['ok'], 2],
    ['is made after a fence that was not answered', ['noise', 'ok'], ['silent', 'ok'], 1],
  ])('%s', async (_, own, others, checks) => {
    const bench = setUp();
    await bench.run(bench.exchange.ask({ name: 'GETMEMORY' }));
    const [ownComes, othersCome] = [inTurn(...own), inTurn(...others)];
    bench.comes = (code) => (code === GETMEMORY ? ownComes() : othersCome());
    let made = 0;
    const beforeRepeat = async () => void made++;
    await bench.run(bench.exchange.ask({ name: 'GETMEMORY' }, undefined, { beforeRepeat }));
    expect(made).toBe(checks);
  });

  it('comes before the first time, too, when the fence before it was not answered', async () => {
    const bench = await unanswered();
    const fences = inTurn('silent', 'ok');
    bench.comes = (code) => (code === MOVETOFUNC ? 'ok' : fences());
    const codes: number[][] = [];
    const beforeRepeat = async () => void codes.push(bench.codes());
    await bench.run(bench.exchange.ask({ name: 'MOVETOFUNC', function: 3 }, undefined, { beforeRepeat }));
    expect(codes).toEqual([[GETSWVER, GETMEMORY]]);
    expect(bench.codes()).toEqual([GETSWVER, GETMEMORY, MOVETOFUNC]);
  });
});

describe('who answers', () => {
  it('is believed to be another timer only when two replies agree', async () => {
    const bench = setUp();
    const replies = ['997', '998', '536', '536'];
    bench.comes = () => version(replies.shift() ?? '536');
    await bench.run(bench.exchange.requireIdentity());
    expect([replies, bench.wire.damage]).toEqual([[], 1]);
  });

  it('may print the letter of another command where it was seen to, or where nothing was seen yet', async () => {
    for (const strict of [true, false]) {
      const bench = setUp();
      const times = Array<number>(11).fill(0);
      const { data } = new FrameDecoder().push(said({ name: 'GETTIMERS', times }))[0] ?? { data: [] };
      bench.comes = (code) => (code === 0x61 ? encodeFrame(0x66, data) : 'ok');
      const asked = bench.exchange.ask({ name: 'GETTIMERS' }, undefined, { strict, tries: 1 });
      if (strict) expect(await bench.run(failureOf(asked))).toMatchObject({ code: 'no-answer' });
      else expect(await bench.run(asked)).toMatchObject({ times });
    }
  });
});

it('an exchange that is closed lets the running request end, and sends no other', async () => {
  const bench = setUp();
  bench.comes = () => 'silent';
  const begin = bench.clock.now();
  const first = bench.run(failureOf(bench.exchange.ask({ name: 'UNLOCK' })));
  await bench.run(bench.exchange.close());
  expect(await first).toMatchObject({ code: 'no-answer' });
  expect(bench.clock.now() - begin).toBeGreaterThan(600);
  bench.sent.length = 0;
  expect(await bench.run(failureOf(bench.exchange.ask({ name: 'GETMEMORY' })))).toMatchObject({ code: 'closed' });
  expect(bench.sent).toEqual([]);
});
