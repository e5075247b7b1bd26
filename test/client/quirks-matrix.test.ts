import { describe, expect, it } from 'vitest';
import type { AssumedQuirks, QuirkCode } from '../../src/client/index.js';
import type { TimerQuirks } from '../../src/simulator/index.js';
import { shareOf } from '../tools/share.js';
import { bench, contentOf, edited, names } from './bench.js';

const found = (client: { quirksFound: ReadonlyMap<QuirkCode, unknown> }): QuirkCode[] => [...client.quirksFound.keys()];

describe('all quirks together', () => {
  const switches = [
    'timersReplyAs66',
    'unlockReplyAs6A',
    'memoryReplyEmpty',
    'bareChecksumReply',
    'bigEndianTimes',
    'servoFirst',
    'memoriesFromOne',
    'servoNeedsMove',
    'bareChecksumRequests',
    'echo',
  ] as const satisfies readonly (keyof TimerQuirks)[];

  it('in all 1024 combinations, verified is never wrong, and with the right choices the goal is reached', async () => {
    const all = Array.from({ length: 2 ** switches.length }, (_, bits) => bits);
    for (const bits of shareOf(all)) {
      const quirks: TimerQuirks = Object.fromEntries(switches.map((name, bit) => [name, (bits & (1 << bit)) !== 0]));
      const { client, timer, run } = bench({ identity: { timerClass: 'Q', functions: 4, servos: 3 }, quirks });
      const label = JSON.stringify(quirks);

      const first = await run(client.readProgram());
      const blind = edited(first, [4, 30000], [1, 2, 99]);
      const report = await run(client.writeProgram(blind, { baseline: first }).catch(() => null));
      if (report?.result === 'verified') {
        expect({ ...contentOf(timer), memory: first.memory }, label).toEqual(blind);
      }
      expect(names(timer.core.answered), label).not.toContain('MOVETOFUNC');

      const { bigEndianTimes, servoFirst, bareChecksumRequests, memoriesFromOne } = quirks;
      const choices: AssumedQuirks = {
        bigEndianTimes: bigEndianTimes === true,
        servoFirst: servoFirst === true,
        bareChecksumRequests: bareChecksumRequests === true,
        memoriesFromOne: memoriesFromOne === true,
      };
      client.assume(choices);
      const baseline = await run(client.readProgram());
      expect({ ...baseline, memory: 0 }, label).toEqual(contentOf(timer));
      const goal = edited(baseline, [4, 20000], [2, 3, 98]);
      const moveServos = quirks.servoNeedsMove === true;
      expect((await run(client.writeProgram(goal, { baseline, moveServos }))).result, label).toBe('verified');
      expect({ ...contentOf(timer), memory: baseline.memory }, label).toEqual(goal);
      await run(client.unlockMotor());
      expect(timer.core.motorLocked, label).toBe(false);
      await run(client.selectMemory(2));
      expect(timer.core.memory, label).toBe(2);

      // What can be told from the line was found, and nothing else.
      const expected = new Set<QuirkCode>();
      if (quirks.timersReplyAs66) expected.add('timers-reply-66');
      if (quirks.unlockReplyAs6A) expected.add('unlock-reply-6a');
      if (quirks.memoryReplyEmpty) expected.add('memory-unknown');
      if (quirks.bareChecksumReply) expected.add('bare-checksum');
      if (quirks.bigEndianTimes) expected.add('times-big-endian');
      if (quirks.echo) expected.add('echo');
      // While the byte order is open the first write is refused, so its read-back tells nothing.
      if (!quirks.bigEndianTimes && quirks.servoNeedsMove) expected.add('positions-unchanged');
      else if (!quirks.bigEndianTimes && quirks.servoFirst) expected.add('servo-first');
      for (const code of expected)
        expect(found(client), `${code} was not found on a timer with ${label}`).toContain(code);
    }
  });
});
