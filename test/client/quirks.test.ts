import { describe, expect, it } from 'vitest';
import type { TimerQuirks } from '../../src/simulator/index.js';
import { bench, contentOf, edited, names } from './bench.js';

describe('a timer that departs from the usual reading', () => {
  it.each<[string, TimerQuirks, string[]]>([
    ['four zeros', { zeros: 4 }, []],
    ['66 for 62', { timersReplyAs66: true }, ['timers-reply-66']],
    ['6A for 6E', { unlockReplyAs6A: true }, ['unlock-reply-6a']],
    ['a bare checksum', { bareChecksumReply: true }, ['bare-checksum']],
    ['memories from 1', { memoriesFromOne: true }, ['memories-from-one']],
    ['an echo', { echo: true }, ['echo']],
  ])('%s: is read, written and understood', async (_, quirks, found) => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' }, quirks });
    timer.core.memory = 3;
    const baseline = await run(client.readProgram());
    expect(baseline).toEqual(contentOf(timer));
    const goal = edited(baseline, [[10, 30000]], [[1, 4, 9]]);
    expect((await run(client.writeProgram(goal, { baseline }))).result).toBe('verified');
    await run(client.unlockMotor());
    expect(timer.core.motorLocked).toBe(false);
    await run(client.selectMemory(1));
    expect(timer.core.memory).toBe(1);
    expect([...client.quirksFound]).toEqual(found);
    expect(client.damageSeen).toBe(false);
  });

  it('no index of the memory: unknown, never memory 0; reading and writing go on', async () => {
    const { client, timer, run } = bench({ quirks: { memoryReplyEmpty: true } });
    const baseline = await run(client.readProgram());
    expect(baseline.memory).toBeNull();
    expect([...client.quirksFound]).toEqual(['memory-unknown']);
    const goal = edited(baseline, [[10, 30000]]);
    expect((await run(client.writeProgram(goal, { baseline }))).result).toBe('verified');
    await run(client.selectMemory(2));
    expect(timer.core.memory).toBe(2);
  });

  it('a misprinted letter is not taken while an earlier request may still be answered', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' } });
    await run(client.identify());
    // MOVETOFUNC goes unanswered; its late reply, 6A, must not free a motor.
    timer.core.sleep();
    await run(client.moveToFunction(1).catch(() => {}));
    await expect(run(client.unlockMotor())).rejects.toMatchObject({ code: 'no-answer', details: { sent: 0 } });
    timer.core.press();
    await run(client.unlockMotor());
    // Behind a fence: a harmless request whose reply shows that nothing older can come.
    expect(names(timer.core.answered).slice(-2)).toEqual(['GETSERVOPOS', 'UNLOCK']);
  });

  it('servo before function: finds it in the reading back, puts the other cell back, and says so', async () => {
    const { client, timer, run } = bench({ quirks: { servoFirst: true } });
    const baseline = await run(client.readProgram());
    const goal = edited(baseline, [], [[2, 1, 99]]);
    const report = await run(client.writeProgram(goal, { baseline }));
    expect(report.result).toBe('differs');
    expect(report.values).toEqual([
      { field: { kind: 'position', servo: 2, column: 1 }, wanted: 99, held: 25, status: 'differs', asked: true },
      { field: { kind: 'position', servo: 1, column: 2 }, wanted: 35, held: 35, status: 'verified', asked: false },
    ]);
    expect([...client.quirksFound]).toEqual(['servo-first']);
    expect(contentOf(timer)).toEqual(baseline);
  });

  it('positions that need a move first: says that nothing changed, and moves nothing', async () => {
    const { client, timer, run } = bench({ quirks: { servoNeedsMove: true } });
    const baseline = await run(client.readProgram());
    const report = await run(client.writeProgram(edited(baseline, [], [[0, 1, 99]]), { baseline }));
    expect(report.result).toBe('differs');
    expect([...client.quirksFound]).toEqual(['positions-unchanged']);
    expect(names(timer.core.answered)).not.toContain('MOVETOFUNC');
    expect(names(timer.core.answered).filter((name) => name === 'SETSERVO')).toHaveLength(1);
  });
});
