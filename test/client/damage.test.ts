import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { B536 } from '../protocol/vectors.js';
import { fromHex } from '../tools/bytes.js';
import { bench, contentOf, edited, names } from './bench.js';

/** A fault that hits the bytes with these numbers only. */
const at =
  (indexes: readonly number[], change: (byte: number) => number[]) =>
  (byte: number, index: number): number[] =>
    indexes.includes(index) ? change(byte) : [byte];
const lose = (): number[] => [];

describe('a line that damages bytes', () => {
  it('asks again for a lost reply, after a fence with another letter', async () => {
    const { client, timer, run } = bench({ fromTimer: { fault: at([18 + 7], lose) } });
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
    expect(names(timer.core.answered).slice(0, 4)).toEqual(['GETSWVER', 'GETMEMORY', 'GETSWVER', 'GETMEMORY']);
  });

  it('needs two readings that agree once damage was seen, and repeats the reading from before', async () => {
    // The second of two flips keeps the sum right: this reply to GETSERVOPOS passes, and is wrong. Damage shows only
    // after it.
    const reply = 18 + 10 + 31;
    const up = at([reply + 7], (byte) => [byte + 1]);
    const down = at([reply + 8], (byte) => [byte - 1]);
    const noise = at([reply + 42], (byte) => [0xaa, byte]);
    const { client, timer, run } = bench({
      fromTimer: {
        fault: (byte, index) =>
          noise(byte, index)
            .flatMap((b) => up(b, index))
            .flatMap((b) => down(b, index)),
      },
    });
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
    expect(client.damageSeen).toBe(true);
    const count = (name: string): number => names(timer.core.answered).filter((n) => n === name).length;
    expect(count('GETTIMERS')).toBe(3);
    expect(count('GETSERVOPOS')).toBe(3);
    expect(count('GETMEMORY')).toBe(5);
    expect(count('GETSWVER')).toBe(3);
  });

  it('gives no program when another timer answers than the one that was identified', async () => {
    const { client, timer, run } = bench({ fromTimer: { fault: at([18], (byte) => [0xaa, byte]) } });
    await run(client.identify());
    Object.assign(timer.core, { identity: { ...B536, firmware: '600' } });
    await expect(run(client.readProgram())).rejects.toMatchObject({ code: 'other-timer' });
  });

  it('does not count noise before the first request', async () => {
    const { client, run, timer } = bench();
    const program = client.readProgram();
    expect(await run(program)).toEqual(contentOf(timer));
    expect(client.damageSeen).toBe(false);
  });

  it('finds a reply after a false header when the line falls silent, without asking again', async () => {
    const header = [...fromHex('00 00 00 00 24 68')];
    const { client, timer, run } = bench({ fromTimer: { fault: at([0], (byte) => [...header, byte]) } });
    expect(await run(client.identify())).toEqual(B536);
    // Damage was seen, so it asked until two agreed: but never because a reply had not come.
    expect(names(timer.core.answered)).toEqual(['GETSWVER', 'GETSWVER']);
  });
});

it('a stop while the line is cleared ends within one reply time, even in the wait for the latest reply', async () => {
  const { client, timer, run, clock } = bench();
  await run(client.identify());
  timer.core.sleep();
  // After about two and a half seconds every letter that could serve as a fence has gone unanswered, and it waits for
  // three more.
  const stop = new AbortController();
  clock.after(3000, () => stop.abort());
  const begin = clock.now();
  await expect(run(client.readProgram({ signal: stop.signal }))).rejects.toMatchObject({ code: 'aborted' });
  expect(clock.now() - begin).toBeLessThan(3100);
});

const fault = fc.record({ index: fc.integer({ min: 0, max: 400 }), kind: fc.constantFrom('lose', 'flip', 'double') });
const faults = fc.array(fault, { maxLength: 6 });
const build = (list: { index: number; kind: string }[]) => (byte: number, index: number) => {
  const hit = list.find((f) => f.index === index);
  if (!hit) return [byte];
  return hit.kind === 'lose' ? [] : hit.kind === 'flip' ? [byte ^ 0x11] : [byte, byte];
};

it('verified means that the timer holds what was wanted, and on a quiet line a second write succeeds', async () => {
  await fc.assert(
    fc.asyncProperty(faults, faults, async (out, back) => {
      let quiet = false;
      const guard = (f: ReturnType<typeof build>) => (byte: number, index: number) => (quiet ? [byte] : f(byte, index));
      const { client, timer, run } = bench({
        identity: { functions: 2, memories: 2, servos: 1 },
        toTimer: { fault: guard(build(out)) },
        fromTimer: { fault: guard(build(back)) },
      });
      const baseline = contentOf(timer);
      const goal = edited(baseline, [2, 9000], [0, 1, 77]);
      const report = await run(client.writeProgram(goal, { baseline }).catch(() => null));
      if (report?.result === 'verified') expect(contentOf(timer)).toEqual(goal);
      quiet = true;
      await run(client.identify().catch(() => {}));
      const held = await run(client.readProgram());
      expect(held).toEqual(contentOf(timer));
      const second = await run(client.writeProgram(goal, { baseline: held }));
      expect(second.result).toBe('verified');
      expect(contentOf(timer)).toEqual(goal);
    }),
    { numRuns: 300 },
  );
});
