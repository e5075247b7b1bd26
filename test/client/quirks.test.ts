import { describe, expect, it } from 'vitest';
import type { QuirkCode } from '../../src/client/index.js';
import { COMMANDS, type CommandName, encodeReply, FrameDecoder } from '../../src/protocol/index.js';
import type { TimerQuirks } from '../../src/simulator/index.js';
import { answering, bench, contentOf, edited, names, readBench } from './bench.js';

const found = (client: { quirksFound: ReadonlyMap<QuirkCode, unknown> }): QuirkCode[] => [...client.quirksFound.keys()];

describe('a timer that differs from the usual one', () => {
  it.each<[string, TimerQuirks, string[]]>([
    ['four zeros', { zeros: 4 }, []],
    ['66 for 62', { timersReplyAs66: true }, ['timers-reply-66']],
    ['6A for 6E', { unlockReplyAs6A: true }, ['unlock-reply-6a']],
    ['a bare checksum', { bareChecksumReply: true }, ['bare-checksum']],
    ['memories from 1', { memoriesFromOne: true }, ['memories-from-one']],
    ['an echo', { echo: true }, ['echo']],
  ])('%s: is read, written and understood', async (_, quirks, expected) => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' }, quirks });
    timer.core.memory = 3;
    const baseline = await run(client.readProgram());
    expect(baseline).toEqual(contentOf(timer));
    const goal = edited(baseline, [10, 30000], [1, 4, 9]);
    expect((await run(client.writeProgram(goal, { baseline }))).result).toBe('verified');
    await run(client.unlockMotor());
    expect(timer.core.motorLocked).toBe(false);
    await run(client.selectMemory(1));
    expect(timer.core.memory).toBe(1);
    expect(found(client)).toEqual(expected);
    expect([client.damageSeen, client.strays]).toEqual([false, 0]);
  });

  it('66 for 62 is not taken in a write by a client that has not seen it: it may be a late reply', async () => {
    const { client, timer, run } = bench({ quirks: { timersReplyAs66: true } });
    const baseline = contentOf(timer);
    await expect(run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }))).rejects.toMatchObject({
      code: 'no-answer',
      details: { request: 'GETTIMERS' },
    });
    expect(contentOf(timer)).toEqual(baseline);
  });

  it('a checksum without the data is found with the first reading, which is made twice', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' }, quirks: { bareChecksumReply: true } });
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
    expect(found(client)).toEqual(['bare-checksum']);
    expect(names(timer.core.answered).filter((name) => name === 'GETLOWRPM')).toHaveLength(2);
  });

  it('an idle throttle without a value is believed after two readings, and after one once it is known', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' } });
    answering(timer, 'GETLOWRPM', (count) => (count === 0 ? [] : undefined));
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
    const other = bench({ identity: { timerClass: 'Q' } });
    answering(other.timer, 'GETLOWRPM', () => []);
    const asked = () => names(other.timer.core.answered).filter((name) => name === 'GETTIMERS').length;
    expect((await other.run(other.client.readProgram())).idleThrottle).toBeNull();
    expect(asked()).toBe(2);
    expect((await other.run(other.client.readProgram())).idleThrottle).toBeNull();
    expect(asked()).toBe(3);
  });

  it('a GETLOWRPM reply of length 3 that carries its byte all the same hides nothing but that byte', async () => {
    const { client, timer, run, clock } = bench({
      identity: { timerClass: 'Q' },
      quirks: { idleThrottleLength3: true },
      baudRate: 9600,
    });
    const begin = clock.now();
    const baseline = await run(client.readProgram());
    expect(clock.now() - begin).toBeLessThan(8000);
    expect(baseline).toEqual({ ...contentOf(timer), idleThrottle: null });
    expect([...client.quirksFound]).toEqual([['replies-alike', { GETLOWRPM: 0x76 }]]);
    const goal = edited(baseline, [10, 30000], [1, 4, 9]);
    expect(await run(client.writeProgram(goal, { baseline }))).toMatchObject({ result: 'verified', stopped: null });
    expect({ ...contentOf(timer), idleThrottle: null }).toEqual(goal);
  });

  it('the length in the sum of one reply: what can be read is read, and the error names that reply', async () => {
    const { client, timer, run } = bench({ quirks: { lengthInSum: ['GETSERVOPOS'] }, baudRate: 9600 });
    const { identity, memory, times } = contentOf(timer);
    await expect(run(client.readProgram())).rejects.toMatchObject({
      code: 'bad-reply',
      details: { request: 'GETSERVOPOS', alike: true, part: { identity, memory, times } },
    });
    expect([...client.quirksFound]).toEqual([['replies-alike', { GETSERVOPOS: 0x68 }]]);
  });

  it('the length in the sum of SETTIMERS and GETMEMORY: read without its memory, written by what is read back', async () => {
    const { client, timer, run, baseline } = await readBench({
      quirks: { lengthInSum: ['SETTIMERS', 'GETMEMORY'] },
      baudRate: 9600,
    });
    expect(baseline).toEqual({ ...contentOf(timer), memory: null });
    const both = edited(baseline, [10, 30000], [1, 4, 9]);
    const report = await run(client.writeProgram(both, { baseline }));
    expect(report).toMatchObject({ result: 'verified', stopped: null });
    expect({ ...contentOf(timer), memory: null }).toEqual(both);
    const found = { GETMEMORY: 0x72, SETTIMERS: 0x66 };
    expect(Object.fromEntries(client.quirksFound)).toEqual({ 'memory-unknown': {}, 'replies-alike': found });
  });

  it('a right reply shows that earlier ones were damaged on their way', async () => {
    const quirks = { lengthInSum: ['GETSERVOPOS'] as CommandName[] };
    const { client, run } = bench({ quirks });
    await expect(run(client.readProgram())).rejects.toMatchObject({ code: 'bad-reply' });
    quirks.lengthInSum = [];
    await run(client.readProgram());
    expect(found(client)).toEqual([]);
  });

  it('a reply without a memory means unknown, never memory 0; reading and writing go on', async () => {
    const { client, timer, run, baseline } = await readBench({ quirks: { memoryReplyEmpty: true } });
    expect(baseline.memory).toBeNull();
    expect(found(client)).toEqual(['memory-unknown']);
    const goal = edited(baseline, [10, 30000]);
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

  it('rounded times: the report says which, and to what', async () => {
    const { client, run, baseline } = await readBench({ quirks: { timeStep: 10 } });
    const report = await run(client.writeProgram(edited(baseline, [3, 255]), { baseline }));
    expect(report).toMatchObject({ result: 'differs', acknowledged: 1 });
    expect(report.values).toMatchObject([{ wanted: 255, held: 250, status: 'differs', asked: true }]);
    expect(client.quirksFound.get('times-rounded')).toEqual({ slot: 3, sent: 255, held: 250 });
  });

  it('the idle throttle of B: read only when asked for, and no answer is no failure', async () => {
    const b = bench();
    expect((await b.run(b.client.readProgram({ idleThrottle: true }))).idleThrottle).toBe(30);
    const silent = bench({ quirks: { idleThrottleOnQOnly: true } });
    expect((await silent.run(silent.client.readProgram({ idleThrottle: true }))).idleThrottle).toBeNull();
    expect(found(silent.client)).toEqual(['idle-throttle-unanswered']);
  });

  it('requests with bare checksums are sent only when the caller assumes them', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' }, quirks: { bareChecksumRequests: true } });
    await run(client.readProgram());
    await expect(run(client.selectMemory(2))).rejects.toMatchObject({
      code: 'no-answer',
      details: { request: 'SETMEMORY' },
    });
    expect(timer.core.memory).toBe(0);
    client.assume({ bareChecksumRequests: true });
    await run(client.selectMemory(2));
    expect(timer.core.memory).toBe(2);
    expect(await run(client.setIdleThrottle(44))).toBe(44);
  });
});

describe('an answer that makes no sense', () => {
  it.each([
    ['none', [], false],
    ['two bytes', [1, 2], true],
  ])('an idle throttle of %s is unknown, and the rest can be read', async (_, data, isDamage) => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' } });
    answering(timer, 'GETLOWRPM', () => data);
    expect(await run(client.readProgram())).toEqual({ ...contentOf(timer), idleThrottle: null });
    expect(found(client)).toEqual(['idle-throttle-malformed']);
    expect(client.damageSeen).toBe(isDamage);
  });

  it('SETTIMERS may be acknowledged without times', async () => {
    const { client, timer, run, baseline } = await readBench();
    answering(timer, 'SETTIMERS', () => []);
    const report = await run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }));
    expect(report).toMatchObject({ result: 'verified', acknowledged: 1, repeats: 0 });
    expect(client.damageSeen).toBe(false);
  });

  it('SETSERVO is not acknowledged by a reply with data, and what the timer holds is still read', async () => {
    const { client, timer, run, baseline } = await readBench();
    answering(timer, 'SETSERVO', () => [1, 2, 3]);
    const goal = edited(baseline, [0, 3, 70]);
    const report = await run(client.writeProgram(goal, { baseline }));
    expect(report).toMatchObject({ held: goal, acknowledged: 0, stopped: null, result: 'verified' });
    expect(found(client)).toEqual([]);
  });

  it('memories that are assumed to count from 1 count from 0 once two replies say 0; one reply is not enough', async () => {
    const { client, timer, run } = bench({}, { quirks: { memoriesFromOne: true } });
    timer.core.memory = 2;
    answering(timer, 'GETMEMORY', (count) => (count === 0 ? [0] : undefined));
    expect((await run(client.readProgram())).memory, 'one answer is not enough: the timer still counts from 1').toBe(1);
    expect(client.quirksAssumed).toEqual({ memoriesFromOne: true });
    timer.core.memory = 0;
    await expect(
      run(client.writeMemories([contentOf(timer)])),
      'the memory that was read has another number now',
    ).rejects.toMatchObject({
      code: 'memory-unknown',
    });
    expect(client.quirksAssumed).toEqual({});
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
  });
});

describe('an identity with bytes that nobody knows', () => {
  it('is believed when two replies agree, and noted', async () => {
    const { client, timer, run } = bench();
    answering(timer, 'GETSWVER', () => [0x42, 0x35, 0x41, 0x36, 0x21, 10, 4, 3, 0]);
    expect(await run(client.identify())).toMatchObject({ timerClass: 'B', firmware: '5A6', functions: 10 });
    expect(names(timer.core.answered)).toEqual(['GETSWVER', 'GETSWVER']);
    expect(found(client)).toEqual(['identity-unusual']);
    const baseline = await run(client.readProgram());
    const report = await run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }));
    expect(report.result).toBe('verified');
  });

  it('is damage when the next reply is a usual one', async () => {
    const { client, timer, run } = bench();
    answering(timer, 'GETSWVER', (count) => (count === 0 ? [0x42, 0x35, 0x41, 0x36, 0x20, 10, 4, 3, 0x20] : undefined));
    expect(await run(client.identify())).toEqual(timer.core.identity);
    expect(found(client)).toEqual([]);
  });
});

it('a timer that wants four zeros gets them in front of each request', async () => {
  const { client, timer, line, run, baseline } = await readBench({}, { quirks: { fourZeros: true } });
  await run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }));
  expect(contentOf(timer).times[10]).toBe(30000);
  const sent = line.filter(({ direction }) => direction === 'out').map(({ bytes }) => bytes);
  expect(sent.map((bytes) => bytes.findIndex((byte) => byte !== 0))).toEqual(sent.map(() => 4));
  expect(sent.map((bytes) => new FrameDecoder().push(bytes).length)).toEqual(sent.map(() => 1));
});

describe('times with their high byte first', () => {
  it('are suspected when they fall and would rise, and are not written before the pilot has chosen', async () => {
    const { client, timer, run } = bench({ quirks: { bigEndianTimes: true } });
    expect(client.byteOrderOpen).toBe(false);
    const read = await run(client.readProgram());
    expect([found(client), client.byteOrderOpen, read.byteOrderOpen]).toEqual([['times-big-endian'], true, true]);
    expect((await run(client.readMemories())).programs.every(({ byteOrderOpen }) => byteOrderOpen)).toBe(true);
    for (const wrong of [edited(read, [10, 30000]), edited(read, [10, 30000], [0, 0, 1])]) {
      await expect(run(client.writeProgram(wrong, { baseline: read }))).rejects.toMatchObject({
        code: 'undecided',
        details: { request: 'SETTIMERS' },
      });
    }
    // Positions do not depend on it.
    const positions = edited(read, [0, 0, 1]);
    expect((await run(client.writeProgram(positions, { baseline: read }))).result).toBe('verified');

    client.assume({ bigEndianTimes: true });
    const baseline = await run(client.readProgram());
    expect(baseline).toEqual(contentOf(timer));
    const goal = edited(baseline, [10, 30000]);
    expect((await run(client.writeProgram(goal, { baseline }))).result).toBe('verified');
    expect(contentOf(timer)).toEqual(goal);
  });

  it('are also suspected where two of them are equal, and times that prove nothing change nothing', async () => {
    const { client, timer, run } = bench();
    const rising = [0x0200, 0x0101, 0x0101, 0x0202, 0x0303, 0x0404, 0x0505, 0x0606, 0x0707, 0x0808];
    timer.core.content.times = [0, ...rising];
    await run(client.readProgram());
    expect(found(client)).toEqual(['times-big-endian']);
    timer.core.content.times = Array<number>(11).fill(0x0101);
    const baseline = await run(client.readProgram());
    await run(client.writeProgram(edited(baseline, [0, 0, 1]), { baseline, despite: ['dt-short'] }));
    expect(found(client)).toEqual(['times-big-endian']);
    timer.core.content.times = Array.from({ length: 11 }, (_, slot) => 100 * Math.ceil(slot / 2));
    await run(client.readProgram());
    expect(found(client), 'times that rise without swapped bytes end the suspicion').toEqual([]);
  });

  it('are a hint only: the pilot may decide that they are as they were read', async () => {
    const { client, timer, run } = bench();
    timer.core.content.times = [0, 0x0200, 0x0101, 0x0202, 0x0303, 0x0404, 0x0505, 0x0606, 0x0707, 0x0808, 0x0909];
    const baseline = await run(client.readProgram());
    expect(found(client)).toEqual(['times-big-endian']);
    client.assume({ bigEndianTimes: false });
    const goal = edited(baseline, [10, 30000]);
    expect((await run(client.writeProgram(goal, { baseline }))).result).toBe('verified');
    expect(goal).toMatchObject(contentOf(timer));
  });
});

describe('servo before function', () => {
  it('is found when reading back; the other cell is put back and reported', async () => {
    const { client, timer, run, baseline } = await readBench({ quirks: { servoFirst: true } });
    const goal = edited(baseline, [2, 1, 99]);
    const report = await run(client.writeProgram(goal, { baseline }));
    expect(report.result).toBe('differs');
    expect(report.values).toEqual([
      { field: { kind: 'position', servo: 2, slot: 1 }, wanted: 99, held: 25, status: 'differs', asked: true },
      { field: { kind: 'position', servo: 1, slot: 2 }, wanted: 35, held: 35, status: 'verified', asked: false },
    ]);
    expect(client.quirksFound.get('servo-first')).toEqual({ servo: 1, slot: 2 });
    expect(contentOf(timer)).toEqual(baseline);
    client.assume({ servoFirst: true });
    expect((await run(client.writeProgram(goal, { baseline }))).result).toBe('verified');
    expect(contentOf(timer)).toEqual(goal);
  });

  it('is disproved in the same way: the other cell is put back in the usual order', async () => {
    const { client, timer, run, baseline } = await readBench({}, { quirks: { servoFirst: true } });
    const goal = edited(baseline, [2, 1, 99]);
    const report = await run(client.writeProgram(goal, { baseline }));
    expect(report.values).toMatchObject([
      { field: { kind: 'position', servo: 2, slot: 1 }, status: 'differs', asked: true },
      { field: { kind: 'position', servo: 1, slot: 2 }, status: 'verified', asked: false },
    ]);
    expect(contentOf(timer)).toEqual(baseline);
    expect(client.quirksAssumed).toEqual({ servoFirst: true });
  });

  it('is suspected when a function number without a servo gets no answer, and nothing is reported as written', async () => {
    const { client, timer, run, baseline } = await readBench({ quirks: { servoFirst: true } });
    const goal = edited(baseline, [1, 3, 99]);
    const report = await run(client.writeProgram(goal, { baseline }));
    expect(report).toMatchObject({ result: 'differs', stopped: { code: 'no-answer' } });
    expect(client.quirksFound.get('servo-unanswered')).toEqual({ servo: 1, slot: 3 });
    expect(found(client), 'no position was acknowledged, so the timer need not have kept any').toEqual([
      'servo-unanswered',
    ]);
    expect(client.quirksAssumed).toEqual({});
    client.assume({ servoFirst: true });
    expect((await run(client.writeProgram(goal, { baseline }))).result).toBe('verified');
    expect(contentOf(timer)).toEqual(goal);
  });
});

describe('positions that are kept only where the servos stand', () => {
  it('are found unchanged, and nothing moves', async () => {
    const { client, timer, run, baseline } = await readBench({ quirks: { servoNeedsMove: true } });
    const report = await run(client.writeProgram(edited(baseline, [0, 1, 99]), { baseline }));
    expect(report.result).toBe('differs');
    expect(found(client)).toEqual(['positions-unchanged']);
    expect(client.quirksAssumed).toEqual({ positionsNeedMove: true });
    expect(names(timer.core.answered)).not.toContain('MOVETOFUNC');
    expect(names(timer.core.answered).filter((name) => name === 'SETSERVO')).toHaveLength(1);
  });

  it('are not suspected by a write of times only', async () => {
    const { client, run, baseline } = await readBench();
    await run(client.writeProgram(edited(baseline, [10, 30000]), { baseline }));
    expect([found(client), client.quirksAssumed]).toEqual([[], {}]);
  });

  it('do not make servos move just because they are known', async () => {
    const { client, timer, run, baseline } = await readBench({}, { quirks: { positionsNeedMove: true } });
    const report = await run(client.writeProgram(edited(baseline, [0, 1, 99]), { baseline }));
    expect([report.result, names(timer.core.answered).includes('MOVETOFUNC')]).toEqual(['verified', false]);
  });

  it.each<[servosMoved: boolean, slots: [number, number], dropped: boolean]>([
    [false, [1, 4], true],
    [false, [1, 1], false],
    [true, [1, 4], false],
  ])(
    'are suspected no longer once two functions kept theirs unmoved (moved: %s, functions %o: %s)',
    async (moveServos, slots, dropped) => {
      const { client, timer, run, baseline } = await readBench();
      const kept = structuredClone(timer.core.content.positions);
      timer.core.onAnswer = ({ name }) => {
        if (name === 'SETSERVO') timer.core.content.positions = structuredClone(kept);
      };
      await run(client.writeProgram(edited(baseline, [0, 1, 99]), { baseline }));
      timer.core.onAnswer = undefined;
      expect([found(client), client.quirksAssumed]).toEqual([['positions-unchanged'], { positionsNeedMove: true }]);
      const goal = edited(baseline, ...slots.map((slot, servo) => [servo, slot, 90 + servo] as const));
      expect((await run(client.writeProgram(goal, { baseline, moveServos }))).result).toBe('verified');
      expect([found(client), client.quirksAssumed]).toEqual(
        dropped ? [[], {}] : [['positions-unchanged'], { positionsNeedMove: true }],
      );
    },
  );

  it('are written when the pilot has agreed that the servos move once to each function', async () => {
    const { client, timer, run, baseline } = await readBench({ quirks: { servoNeedsMove: true } });
    const goal = edited(baseline, [0, 1, 99], [0, 4, 98], [2, 1, 97]);
    timer.core.answered.length = 0;
    const report = await run(client.writeProgram(goal, { baseline, moveServos: true }));
    expect([report.result, report.acknowledged]).toEqual(['verified', 3]);
    expect(names(timer.core.answered).slice(6, 11)).toEqual([
      'MOVETOFUNC',
      'SETSERVO',
      'SETSERVO',
      'MOVETOFUNC',
      'SETSERVO',
    ]);
    expect(contentOf(timer)).toEqual(goal);
  });
});

describe('what was found of a timer', () => {
  it('is kept while a timer of the same kind answers, and dropped when another kind does', async () => {
    const { client, timer, run } = bench(
      { identity: { timerClass: 'Q' }, quirks: { echo: true } },
      { quirks: { servoFirst: false } },
    );
    await run(client.identify());
    client.assume({ memoriesFromOne: false });
    await run(client.identify());
    expect([found(client), client.quirksAssumed]).toEqual([['echo'], { servoFirst: false, memoriesFromOne: false }]);
    timer.core.answer = ((answer) => (frame, bare) => {
      const reply = answer(frame, bare);
      return frame.code === COMMANDS.GETSWVER.request && reply
        ? encodeReply({ name: 'GETSWVER', identity: { ...timer.core.identity, timerClass: 'E' } })
        : reply;
    })(timer.core.answer.bind(timer.core));
    await run(client.identify());
    expect(client.quirksAssumed).toEqual({ servoFirst: false });
  });

  it('is forgotten with all assumptions when the caller asks for that', async () => {
    const { client, run } = bench({ quirks: { echo: true } }, { quirks: { servoFirst: true } });
    await run(client.identify());
    client.forgetQuirks();
    expect([found(client), client.quirksAssumed]).toEqual([[], {}]);
  });
});

it('a version reply may have another letter, which works as a timer of unknown class', async () => {
  const { client, timer, run, baseline } = await readBench({ identity: { timerClass: 'X' } });
  const goal = edited(baseline, [10, 30000]);
  expect((await run(client.writeProgram(goal, { baseline }))).result).toBe('verified');
  expect(contentOf(timer)).toEqual(goal);
});
