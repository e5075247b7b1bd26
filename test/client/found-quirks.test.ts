import { describe, expect, it } from 'vitest';
import { Quirks } from '../../src/client/quirks.js';

describe('what a timer was found to do differently', () => {
  it('keeps the facts of the first time', () => {
    const quirks = new Quirks({});
    quirks.note('memory-impossible', { index: 7 });
    quirks.note('memory-impossible', { index: 8 });
    expect(quirks.found.get('memory-impossible')).toEqual({ index: 7 });
  });

  it('is forgotten when another timer comes, but what the caller has assumed is not', () => {
    const quirks = new Quirks({ servoFirst: true });
    quirks.note('echo');
    quirks.assume({ memoriesFromOne: true });
    quirks.noteForm('GETTIMERS', 'misprint');
    quirks.noteForm('GETTIMERS', 'misprint');
    quirks.reset();
    expect([quirks.found.size, quirks.assumed]).toEqual([0, { servoFirst: true }]);
    expect(quirks.mayMisprint('GETTIMERS', 'known')).toBe(false);
  });

  it('is dropped alone when the timer contradicts it', () => {
    const quirks = new Quirks({ servoFirst: true, memoriesFromOne: true });
    quirks.note('memories-from-one');
    quirks.note('echo');
    quirks.found.delete('memories-from-one');
    quirks.unassume('memoriesFromOne');
    expect([[...quirks.found.keys()], quirks.assumed]).toEqual([['echo'], { servoFirst: true }]);
  });
});

it('the misprinted form of a reply is believed when it comes twice, and no longer after the right one came', () => {
  const quirks = new Quirks({});
  const seen = () => [
    quirks.mayMisprint('GETTIMERS', 'yes'),
    quirks.mayMisprint('GETTIMERS', 'known'),
    quirks.isMisprintNew('GETTIMERS'),
    quirks.found.has('timers-reply-66'),
  ];
  expect(seen()).toEqual([true, false, false, false]);
  quirks.noteForm('GETTIMERS', 'misprint');
  expect(seen()).toEqual([true, false, true, false]);
  quirks.noteForm('GETTIMERS', 'misprint');
  expect(seen()).toEqual([true, true, false, true]);
  quirks.noteForm('GETTIMERS', 'exact');
  expect(seen()).toEqual([false, false, false, false]);
  quirks.noteForm('GETTIMERS', 'misprint');
  expect(seen()).toEqual([false, false, false, false]);
});

it('bare checksums of requests are for SETMEMORY and SETLOWRPM, and only when assumed', () => {
  const requests = [
    { name: 'SETMEMORY', memory: 1 },
    { name: 'SETLOWRPM', idleThrottle: 1 },
    { name: 'GETSWVER' },
  ] as const;
  const bare = (quirks: Quirks) => requests.map((request) => quirks.isBare(request));
  expect(bare(new Quirks({ bareChecksumRequests: true }))).toEqual([true, true, false]);
  expect(bare(new Quirks({}))).toEqual([false, false, false]);
  expect(bare(new Quirks({ bareChecksumRequests: false }))).toEqual([false, false, false]);
});
