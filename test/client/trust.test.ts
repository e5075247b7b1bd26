import { describe, expect, it } from 'vitest';
import { TimerClient, type WriteReport } from '../../src/client/index.js';
import { VirtualClock } from '../../src/line/index.js';
import type { TimerProgram } from '../../src/program/index.js';
import { COMMANDS, type Identity } from '../../src/protocol/index.js';
import { type TimerQuirks, VirtualTimer } from '../../src/simulator/index.js';
import { contentOf, edited, names, readBench } from './bench.js';
import { FRESH, Head, SETS, SMALL, VERIFY } from './head.js';
import { everyValueChanged } from './matrix.js';

/** What the pilot changes: DT, and a position. */
const goalOf = (program: TimerProgram): TimerProgram => edited(program, [2, 9000], [0, 1, 77]);
function setsOf({ core }: VirtualTimer): string[] {
  return names(core.answered).filter((name) => name.startsWith('SET'));
}

type Second = 'another class' | 'another content' | 'the same content';

/**
 * Confirms a write on the first timer and holds the head over another one from a request of the write on, counted from
 * 1. So many requests neither hears: they are lost on the way from one to the other.
 */
async function swapped(second: Second, swapAt: number, lost = 0) {
  const clock = new VirtualClock();
  const first = new VirtualTimer({ clock, identity: SMALL });
  const identity: Partial<Identity> = second === 'another class' ? { ...SMALL, timerClass: 'E' } : SMALL;
  const other = new VirtualTimer({ clock, identity });
  if (second === 'another content') Object.assign(other.core.content, everyValueChanged(contentOf(other)));
  const before = structuredClone(contentOf(other));
  const port = new Head(first, other);
  const client = new TimerClient(port, { clock });
  const baseline = await clock.run(client.readProgram());
  const goal = goalOf(baseline);
  port.requests = 0;
  port.asked = () => {
    if (port.requests >= swapAt) port.at = other;
    return port.requests < swapAt || port.requests >= swapAt + lost;
  };
  const result = await clock.run(client.writeProgram(goal, { baseline }).catch((error: unknown) => error));
  return { first, other, before, goal, result: result as Partial<WriteReport> & { code?: string } };
}

describe('another timer under the infrared head, from any request of a write on', () => {
  const requests = Array.from({ length: FRESH + SETS + VERIFY }, (_, index) => index + 1);

  it.each<[Second, number, string]>([
    // Class, firmware and layout are asked for right before the first value.
    ['another class', FRESH, 'other-timer'],
    // The content was read by then. What comes between that and the first value cannot be noticed, and nothing
    // identifies a timer.
    ['another content', 4, 'stale'],
  ])('%s: up to request %i nothing is written', async (second, last, code) => {
    for (const swapAt of requests.filter((request) => request <= last)) {
      const { first, other, before, result } = await swapped(second, swapAt);
      expect(result.code, `the other timer came at request ${swapAt}`).toBe(
        swapAt === 4 && code === 'stale' ? 'stale' : code,
      );
      expect([setsOf(first), setsOf(other)], `the other timer came at request ${swapAt}`).toEqual([[], []]);
      expect(contentOf(other)).toEqual(before);
    }
  });

  it.each<Second>(['another class', 'another content', 'the same content'])(
    '%s: verified only when the one that was read holds the goal; nothing is put back or sent again',
    async (second) => {
      for (const swapAt of requests) {
        const { first, other, goal, result } = await swapped(second, swapAt);
        const label = `${swapAt}: ${result.result ?? result.code}`;
        if (result.result === 'verified') {
          // The content was read for the last time from the one that heard that request. Only between the last look at
          // the first timer and the first value, a moment in which nothing identifies a timer, does another one pass:
          // it then holds the goal.
          expect(second, label).not.toBe('another class');
          const holder = swapAt > FRESH + SETS + 6 ? first : other;
          expect(contentOf(holder), label).toEqual(goal);
          if (holder === other) expect(swapAt, label).toBeLessThanOrEqual(FRESH + 1);
        }
        // Behind the first value nothing is put back into another timer, and nothing is sent again.
        if (swapAt > FRESH + 1) expect(setsOf(first).length + setsOf(other).length, label).toBeLessThanOrEqual(SETS);
        if (swapAt > FRESH + SETS) expect(setsOf(other), label).toEqual([]);
        // The content has been read twice by then: the last request can only show another class.
        if (second === 'another class') expect(result.code ?? result.stopped?.code, label).toBe('other-timer');
        if (swapAt > FRESH + 1 && swapAt <= FRESH + SETS + 6) expect(result.result, label).not.toBe('verified');
      }
    },
  );
});

describe('another timer under the infrared head, after silence among the values', () => {
  const sets = [FRESH + 1, FRESH + 2];

  it.each([1, 2, 4])('with other content: it gets none of them, however many requests were lost: %i', async (lost) => {
    for (const swapAt of sets) {
      const { other, before, result } = await swapped('another content', swapAt, lost);
      expect(result, `the other timer came at request ${swapAt}`).toMatchObject({
        result: 'unknown',
        stopped: { code: 'changed' },
      });
      expect(setsOf(other), `the other timer came at request ${swapAt}`).toEqual([]);
      expect(contentOf(other)).toEqual(before);
    }
  });

  it('of another class: it gets none of them', async () => {
    for (const swapAt of sets) {
      const { other, result } = await swapped('another class', swapAt, 1);
      expect(result.stopped, `the other timer came at request ${swapAt}`).toMatchObject({ code: 'other-timer' });
      expect(setsOf(other), `the other timer came at request ${swapAt}`).toEqual([]);
    }
  });
});

it.each(['other', 'same'])(
  'another memory with %s content during the reading back is never verified, and never written',
  async (content) => {
    for (let at = 0; at < VERIFY; at++) {
      const { client, timer, run, baseline } = await readBench({ identity: SMALL });
      const goal = goalOf(baseline);
      if (content === 'same') Object.assign(timer.core.memories[1] as object, structuredClone(goal));
      const before = structuredClone(timer.core.memories[1]);
      let left = at;
      timer.core.onAnswer = () => {
        if (setsOf(timer).length === SETS && left-- === 0) timer.core.memory = 1;
      };
      const report = await run(client.writeProgram(goal, { baseline }));
      // After the answer to the last GETMEMORY nothing asks again.
      const isSeen = at < VERIFY - 1;
      expect(report.result, `the memory changed at request ${at}`).toBe(isSeen ? 'unknown' : 'verified');
      if (isSeen) expect(report.stopped?.code, `the memory changed at request ${at}`).toBe('other-memory');
      expect(timer.core.memories[1], `the memory changed at request ${at}`).toEqual(before);
      expect(timer.core.memories[0]?.times, `the memory changed at request ${at}`).toEqual(goal.times);
    }
  },
);

it.each<[string, TimerQuirks]>([
  ['', {}],
  [' of a timer that answers GETTIMERS with 66', { timersReplyAs66: true }],
])('an acknowledgement that comes twice at any place%s is never taken for a reading', async (_, quirks) => {
  for (let hit = 0; hit < FRESH + SETS + VERIFY; hit++) {
    for (const place of ['at once', 'before 1', 'after 1', 'before 2', 'after 2'] as const) {
      const { client, timer, run, baseline } = await readBench({ identity: SMALL, quirks });
      const goal = goalOf(baseline);
      const answer = timer.core.answer.bind(timer.core);
      let count = 0;
      let copy = new Uint8Array(0);
      timer.core.answer = (frame, bare) => {
        const reply = answer(frame, bare) as Uint8Array<ArrayBuffer>;
        const after = count++ - hit;
        if (after === 0) copy = reply;
        if (place === 'at once' && after === 0) return Uint8Array.of(...reply, ...copy);
        if (after <= 0 || !place.endsWith(String(after))) return reply;
        return place.startsWith('before') ? Uint8Array.of(...copy, ...reply) : Uint8Array.of(...reply, ...copy);
      };
      const label = `reply ${hit} comes twice, ${place}`;
      const report = await run(client.writeProgram(goal, { baseline }));
      expect(report.result, label).toBe('verified');
      expect(contentOf(timer), label).toEqual(goal);
      expect([...client.quirksFound.keys()], label).toEqual(quirks.timersReplyAs66 ? ['timers-reply-66'] : []);
    }
  }
});

it('a second reply to the first reading is no second reading of what has changed meanwhile', async () => {
  const { client, timer, run, baseline } = await readBench({ identity: SMALL });
  const answer = timer.core.answer.bind(timer.core);
  let copy = new Uint8Array(0);
  let asked = 0;
  timer.core.answer = (frame, bare) => {
    const isRead = setsOf(timer).length === SETS && frame.code === COMMANDS.GETSERVOPOS.request;
    if (isRead) asked++;
    if (isRead && asked === 2) timer.core.content.positions[0]?.splice(0, 1, 1);
    const reply = answer(frame, bare) as Uint8Array<ArrayBuffer>;
    if (isRead && asked === 1) copy = reply;
    return isRead && asked === 2 ? Uint8Array.of(...copy, ...reply) : reply;
  };
  const report = await run(client.writeProgram(goalOf(baseline), { baseline }));
  expect(asked).toBeGreaterThan(2);
  expect(report.result === 'verified', 'a write is verified exactly when the timer holds the goal').toBe(
    JSON.stringify(contentOf(timer)) === JSON.stringify(goalOf(baseline)),
  );
});
