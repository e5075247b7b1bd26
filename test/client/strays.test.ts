import { describe, expect, it } from 'vitest';
import { TimerClient } from '../../src/client/index.js';
import { VirtualClock } from '../../src/line/index.js';
import {
  type Bytes,
  COMMANDS,
  type CommandName,
  encodeFrame,
  encodeReply,
  type Reply,
} from '../../src/protocol/index.js';
import { VirtualTimer } from '../../src/simulator/index.js';
import { contentOf, edited, names } from './bench.js';
import { type Crowd, crowd, type Moment } from './crowd.js';

function setUp() {
  const clock = new VirtualClock(1_700_000_000_000);
  const timer = new VirtualTimer({ clock, identity: { timerClass: 'Q' } });
  const port: Crowd = crowd(timer);
  const client = new TimerClient(port, { clock });
  return { clock, timer, port, client, run: <T>(promise: Promise<T>) => clock.run(promise) };
}

const { identity } = new VirtualTimer({ identity: { timerClass: 'Q' } }).core;

/** What another timer of the same kind would say, with other values in all of it. */
const OTHERS: Readonly<Record<CommandName, Bytes>> = {
  GETTIMERS: said({ name: 'GETTIMERS', times: Array.from({ length: 11 }, (_, slot) => 111 * slot) }),
  SETTIMERS: said({ name: 'SETTIMERS', times: Array.from({ length: 11 }, (_, slot) => 111 * slot) }),
  GETSERVOPOS: said({ name: 'GETSERVOPOS', positions: Array.from({ length: 3 }, () => Array<number>(11).fill(99)) }),
  GETSWVER: said({ name: 'GETSWVER', identity: { ...identity, firmware: '999' } }),
  GETMEMORY: said({ name: 'GETMEMORY', memory: 3 }),
  GETLOWRPM: said({ name: 'GETLOWRPM', idleThrottle: 77 }),
  SETSERVO: said({ name: 'SETSERVO' }),
  SETMEMORY: said({ name: 'SETMEMORY' }),
  SETLOWRPM: said({ name: 'SETLOWRPM' }),
  MOVETOFUNC: said({ name: 'MOVETOFUNC' }),
  UNLOCK: said({ name: 'UNLOCK' }),
  JUMP2: said({ name: 'JUMP2' }),
};

function said(reply: Reply): Bytes {
  return encodeReply(reply, { identity });
}

/** The requests of identify() and a reading on a clean line. */
const READING: readonly CommandName[] = ['GETSWVER', 'GETMEMORY', 'GETTIMERS', 'GETSERVOPOS', 'GETLOWRPM'];

describe('a frame that nobody asked for', () => {
  it('is counted, and an echo, an expected or a late reply is not', async () => {
    const { client, run, port, timer } = setUp();
    await run(client.readProgram());
    expect(client.strays).toBe(0);
    port.stray = (_, code, moment) => (moment === 'before' ? encodeFrame(code) : undefined);
    await run(client.readProgram());
    expect(client.quirksFound.has('echo')).toBe(true);
    expect(client.strays).toBe(0);
    // The request of another programmer is no echo.
    port.stray = (_, code, moment) => (moment === 'before' && code === 0x61 ? encodeFrame(0x63, [1, 2, 3]) : undefined);
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
    expect(client.strays).toBeGreaterThan(0);
    expect(client.damageSeen).toBe(false);
  });

  it('counts as a late reply to a request whose time is up, but only once', async () => {
    const { client, run, port, timer } = setUp();
    await run(client.identify());
    timer.core.sleep();
    await expect(run(client.moveToFunction(3))).rejects.toMatchObject({ code: 'no-answer' });
    port.say(OTHERS.MOVETOFUNC);
    timer.core.press();
    await run(client.readProgram());
    expect(client.strays).toBe(0);
    timer.core.sleep();
    await expect(run(client.moveToFunction(3))).rejects.toMatchObject({ code: 'no-answer' });
    timer.core.press();
    port.say(OTHERS.MOVETOFUNC);
    port.say(OTHERS.MOVETOFUNC);
    await run(client.readProgram());
    expect(client.strays).toBe(1);
  });

  it.each(
    Object.keys(OTHERS).flatMap((name) =>
      READING.flatMap((at) =>
        (['before', 'after'] as const).map((moment) => [name as CommandName, moment, at] as const),
      ),
    ),
  )('%s %s the reply to %s gives no value that two readings did not agree on', async (name, moment, at) => {
    const { client, run, port, timer } = setUp();
    await run(client.identify());
    let index = -1;
    let done = false;
    port.stray = (_, code, when: Moment) => {
      if (when === 'before') index = code;
      if (done || when !== moment || index !== COMMANDS[at].request) return undefined;
      done = true;
      return OTHERS[name];
    };
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
    // What came after the last reply of all is seen in the next reading.
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
    if (done) expect(client.strays).toBeGreaterThan(0);
  });

  it.each(Object.keys(OTHERS) as CommandName[])(
    '%s at any request of a write makes no word of it false',
    async (name) => {
      for (let at = 0; ; at++) {
        const { client, run, port, timer } = setUp();
        const baseline = await run(client.readProgram());
        const goal = edited(baseline, [10, 30000], [1, 4, 99]);
        let count = 0;
        port.stray = (_, __, moment) => (moment === 'before' && count++ === at ? OTHERS[name] : undefined);
        const report = await run(client.writeProgram(goal, { baseline }));
        if (report.result === 'verified') expect(contentOf(timer)).toEqual(goal);
        if (report.held) expect(report.held).toEqual(contentOf(timer));
        if (count <= at) break;
      }
    },
  );

  it('in place of each reply leads to an error about a second timer', async () => {
    const { client, run, port } = setUp();
    await run(client.identify());
    let count = 0;
    port.stray = (_, code, moment) =>
      moment === 'before' && code === COMMANDS.GETLOWRPM.request
        ? said({ name: 'GETLOWRPM', idleThrottle: 100 + count++ })
        : undefined;
    await expect(run(client.readProgram().then(() => client.readProgram()))).rejects.toMatchObject({
      code: 'crowded',
      details: { request: 'GETLOWRPM' },
    });
  });
});

describe('a fence that another timer answers', () => {
  it('stops the job, and says what answered', async () => {
    const { client, run, timer } = setUp();
    await run(client.identify());
    let asleep = true;
    const answer = timer.core.answer.bind(timer.core);
    timer.core.answer = (frame) => {
      // The timer is exchanged for one of the same layout while a request goes unanswered.
      if (frame.code === COMMANDS.GETMEMORY.request && asleep) {
        asleep = false;
        Object.assign(timer.core, { identity: { ...identity, timerClass: 'B' } });
        return undefined;
      }
      return answer(frame);
    };
    await expect(run(client.readProgram())).rejects.toMatchObject({
      code: 'other-timer',
      details: { identity: { timerClass: 'B' } },
    });
    expect(names(timer.core.answered).slice(1)).toEqual(['GETSWVER', 'GETSWVER']);
  });

  it('is sent again before that is believed, and damage makes each value be read twice', async () => {
    const { client, run, timer } = setUp();
    await run(client.identify());
    let lost = 1;
    let wrong = 1;
    const answer = timer.core.answer.bind(timer.core);
    timer.core.answer = (frame) => {
      if (frame.code === COMMANDS.GETMEMORY.request && lost-- > 0) return undefined;
      if (frame.code === COMMANDS.GETSWVER.request && wrong-- > 0) return OTHERS.GETSWVER;
      return answer(frame);
    };
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
    expect(client.damageSeen).toBe(true);
    expect(names(timer.core.answered).filter((name) => name === 'GETTIMERS')).toHaveLength(2);
  });
});
