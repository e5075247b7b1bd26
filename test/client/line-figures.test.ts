import { describe, expect, it } from 'vitest';
import { LearnedTiming } from '../../src/client/line-timing.js';
import { asReply, replySize } from '../../src/client/outcome.js';
import { Quirks } from '../../src/client/quirks.js';
import {
  exchangesOf,
  LATEST_REPLY,
  longestExchange,
  longestExchanges,
  longestFence,
  overtime,
  replyTime,
} from '../../src/client/retry-policy.js';
import { UnansweredRequests } from '../../src/client/unanswered.js';
import { VirtualClock, wireTime } from '../../src/line/index.js';
import { encodeRequest, type Identity, type Request } from '../../src/protocol/index.js';

const identity: Identity = { timerClass: 'B', firmware: '536', functions: 10, memories: 4, servos: 3 };
/** One byte takes one millisecond. */
const timing = { baudRate: 10_000, margin: 600 };
const bytes = (...data: number[]) => Uint8Array.from(data);

describe('how long things may take', () => {
  it('a reply: its bytes and the margin', () => {
    expect(replyTime(18, timing)).toBe(618);
  });

  it('bytes that are still coming: the longest frame and a silence', () => {
    expect(overtime(timing)).toBe(261 + 60);
  });

  it('exchanges: all bytes, and for each the margin, what else may come, and a silence', () => {
    // GETSWVER: 9 and 18 bytes; GETMEMORY: 9 and 10.
    expect(exchangesOf(['GETSWVER', 'GETMEMORY'], identity)).toEqual({ count: 2, bytes: 46 });
    expect(longestExchanges({ count: 2, bytes: 46 }, timing)).toBe(46 + 2 * (600 + 321 + 60));
    expect(longestExchange('GETSWVER', identity, timing)).toBe(27 + 981);
    expect(exchangesOf([], identity)).toEqual({ count: 0, bytes: 0 });
  });

  it('exchanges with a timer that is not known: the longest frames', () => {
    expect(exchangesOf(['GETSWVER'], null)).toEqual({ count: 1, bytes: 522 });
  });

  it('a fence: draining, and either the latest possible reply or an exchange of the longest frames', () => {
    expect(longestFence(timing)).toBe(1060 + LATEST_REPLY);
    expect(longestFence({ baudRate: 100, margin: 600 })).toBe(1060 + (52_200 + 600) + (26_100 + 60) + 60);
  });

  it('the reply to a request: as the layout says; before the timer is known, the longest', () => {
    expect(replySize('GETMEMORY', identity)).toBe(10);
    expect([replySize('GETSWVER', null), replySize('GETMEMORY', null)]).toEqual([18, 261]);
  });
});

const learned = (...delays: number[]) => {
  const own = new LearnedTiming(timing);
  for (const delay of delays) own.learn(delay);
  return [own.delay, own.margin];
};

it.each<[string, number[], [number | null, number]]>([
  ['nothing came late', [], [null, 600]],
  ['a reply that came late makes the margin half as long again', [1000], [1000, 1500]],
  ['a delay of 0 teaches nothing', [0], [null, 600]],
  ['a reply that came before its time teaches nothing', [-5], [null, 600]],
  ['of several the slowest counts', [1000, 900], [1000, 1500]],
  ['a slower one replaces the one before', [1000, 1100], [1100, 1650]],
  ['a delay within the margin changes only the delay that is reported', [300], [300, 600]],
  ['the latest reply bounds the margin', [2900], [2900, LATEST_REPLY]],
  ['the latest reply itself counts', [LATEST_REPLY], [LATEST_REPLY, LATEST_REPLY]],
  ['a reply that comes even later does not count', [LATEST_REPLY + 1], [null, 600]],
])('how slow the timer was found to be: %s', (_, delays, expected) => {
  expect(learned(...delays)).toEqual(expected);
});

describe('requests that may still be answered', () => {
  const make = () => {
    const clock = new VirtualClock(5000);
    const own = new LearnedTiming(timing);
    const requests = new UnansweredRequests(clock, own);
    const send = (request: Request, isUnanswered = true): void =>
      requests.note(encodeRequest(request, { identity }), clock.now(), isUnanswered);
    return { clock, own, requests, send };
  };
  const version = { code: 0x6c, data: new Uint8Array(9) };

  it('are known by their letters, until all is settled', () => {
    const { requests, send } = make();
    expect(requests.isEmpty).toBe(true);
    send({ name: 'GETSWVER' });
    expect([requests.isEmpty, requests.has(0x6b), requests.has(0x61)]).toEqual([false, true, false]);
    expect([requests.hasOnly(0x6b), requests.hasOnly(0x61)]).toEqual([true, false]);
    send({ name: 'GETTIMERS' });
    expect([requests.hasOnly(0x6b), requests.hasOnly(0x61)]).toEqual([false, false]);
    requests.settle();
    expect(requests.isEmpty).toBe(true);
  });

  it('do not include an answered one, unless one before it is open', () => {
    const { requests, send } = make();
    send({ name: 'GETSWVER' }, false);
    expect(requests.isEmpty).toBe(true);
    send({ name: 'GETSWVER' });
    send({ name: 'GETSWVER' }, false);
    expect([requests.take(version, true), requests.take(version, true)]).toEqual([true, false]);
  });

  it('become one fewer with each late reply', () => {
    const { requests, send } = make();
    send({ name: 'GETSWVER' });
    send({ name: 'GETSWVER' });
    expect([1, 2, 3].map(() => requests.take(version, true))).toEqual([true, true, false]);
    expect(requests.has(0x6b), 'a doubled reply may still come').toBe(true);
  });

  it('are not answered by a frame of another letter', () => {
    const { requests, send } = make();
    send({ name: 'GETSWVER' });
    expect(requests.take({ code: 0x62, data: bytes() }, true)).toBe(false);
    expect(requests.take(version, true)).toBe(true);
  });

  it('are also answered by a misprinted letter: 66 for GETTIMERS', () => {
    const { requests, send } = make();
    send({ name: 'GETTIMERS' });
    expect(requests.take({ code: 0x66, data: bytes() }, true)).toBe(true);
  });

  it('include a frame by hand: one of an unknown letter is answered by the next letter', () => {
    const { clock, requests } = make();
    requests.note(bytes(0, 0, 0, 0, 0, 3, 0x81, 0x81, 0x45), clock.now(), true);
    expect(requests.take({ code: 0x84, data: bytes() }, true)).toBe(false);
    expect(requests.take({ code: 0x82, data: bytes() }, true)).toBe(true);
  });

  it('teach how slow the timer is, beyond the bytes of request and reply', async () => {
    const { clock, own, requests, send } = make();
    send({ name: 'GETSWVER' });
    send({ name: 'GETSWVER' });
    await clock.advance(1000);
    requests.take(version, false);
    expect(own.delay, 'a reply that was hidden behind a false header does not count').toBeNull();
    requests.take(version, true);
    expect(own.delay).toBe(1000 - wireTime(9 + 18, 10_000));
  });
});

describe('a frame as the reply to a question', () => {
  const times = bytes(1, 0, 2, 0);
  const ask = (request: Request, how: 'no' | 'known' | 'yes' = 'yes') => ({
    request,
    identity: null,
    ...(how === 'no' ? {} : { misprints: how }),
  });

  it('is its own answer by its letter', () => {
    const quirks = new Quirks({});
    const answer = { name: 'GETTIMERS', times: [1, 2] };
    expect(asReply({ code: 0x62, data: times }, ask({ name: 'GETTIMERS' }), quirks, false)).toEqual({
      kind: 'answer',
      answer,
    });
    expect(asReply({ code: 0x6c, data: times }, ask({ name: 'GETTIMERS' }), quirks, false)).toBeUndefined();
    expect(quirks.mayMisprint('GETTIMERS', 'yes'), 'this timer has used the right letter').toBe(false);
  });

  it('may be a misprint where nothing else can be answered, and the timer is not known to print right', () => {
    const frame = { code: 0x66, data: times };
    const kinds = (quirks: Quirks) =>
      (['no', 'known', 'yes'] as const).map(
        (how) => asReply(frame, ask({ name: 'GETTIMERS' }, how), quirks, false)?.kind,
      );
    expect(kinds(new Quirks({}))).toEqual([undefined, undefined, 'answer']);
    const known = new Quirks({});
    known.noteForm('GETTIMERS', 'misprint');
    known.noteForm('GETTIMERS', 'misprint');
    expect(kinds(known)).toEqual([undefined, 'answer', 'answer']);
    const right = new Quirks({});
    right.noteForm('GETTIMERS', 'exact');
    expect(kinds(right)).toEqual([undefined, undefined, undefined]);
  });

  it.each([
    ['none, because its value is 0 and the letter is its true sum', bytes(0), true, true],
    ['a misprint, because its value is 7', bytes(7), true, false],
    ['none, because its sum is the true one', bytes(7), false, true],
  ])('with its letter as its sum it is a misprint or not: %s', (_, data, isBare, isUsual) => {
    const quirks = new Quirks({});
    for (let i = 0; i < 2; i++) asReply({ code: 0x76, data }, ask({ name: 'GETLOWRPM' }), quirks, isBare);
    expect(quirks.found.has('bare-checksum')).toBe(!isUsual);
  });

  it('with its letter as its sum it is no answer where something else can be answered', () => {
    const question = ask({ name: 'GETLOWRPM' }, 'no');
    expect(asReply({ code: 0x76, data: bytes(7) }, question, new Quirks({}), true)).toBeUndefined();
  });

  it('with a value of 0 says nothing about other values', () => {
    const quirks = new Quirks({});
    asReply({ code: 0x76, data: bytes(0) }, ask({ name: 'GETLOWRPM' }), quirks, false);
    expect(quirks.mayMisprint('GETLOWRPM', 'yes')).toBe(true);
    asReply({ code: 0x76, data: bytes(7) }, ask({ name: 'GETLOWRPM' }), quirks, false);
    expect(quirks.mayMisprint('GETLOWRPM', 'yes')).toBe(false);
  });
});
