import { describe, expect, it } from 'vitest';
import { BAD_REPLIES, READS } from '../../src/client/retry-policy.js';
import { answering, type Bench, bench, contentOf, memoryOf, names } from './bench.js';

/** A client that has seen damage, so that it believes no single answer. */
async function suspicious(timerClass = 'B'): Promise<Bench> {
  let lost = 1;
  const made = bench({ identity: { timerClass }, fromTimer: { fault: (byte) => (lost-- > 0 ? [0xff] : [byte]) } });
  await made.run(made.client.identify());
  made.timer.core.answered.length = 0;
  return made;
}

describe('answers of which no two agree', () => {
  it('to one question: the client gives up after six', async () => {
    const { client, timer, run } = await suspicious();
    answering(timer, 'GETMEMORY', (count) => [count % 2]);
    await expect(run(client.request({ name: 'GETMEMORY' }))).rejects.toMatchObject({
      code: 'unstable',
      message: `no two of ${READS} replies agreed`,
      details: { request: 'GETMEMORY' },
    });
    expect(names(timer.core.answered)).toEqual(Array(READS).fill('GETMEMORY'));
  });

  it.each<['GETTIMERS' | 'GETSERVOPOS' | 'GETLOWRPM', (core: Bench['timer']['core']) => unknown]>([
    ['GETTIMERS', ({ content }) => content.times.splice(3, 1, (content.times[3] as number) ^ 1)],
    ['GETSERVOPOS', ({ content }) => content.positions[1]?.splice(3, 1, (content.positions[1][3] as number) ^ 1)],
    ['GETLOWRPM', (core) => Object.assign(core, { idleThrottle: core.idleThrottle ^ 1 })],
  ])('to the questions for a memory: the client gives up after six, and names %s', async (request, change) => {
    const { client, timer, run } = await suspicious('Q');
    timer.core.onAnswer = ({ name }) => name === request && change(timer.core);
    await expect(run(client.readProgram())).rejects.toMatchObject({
      code: 'unstable',
      message: `no two of ${READS} readings agreed`,
      details: { request },
    });
    expect(names(timer.core.answered).filter((name) => name === request)).toHaveLength(READS);
  });

  it('which memory is current, at the beginning and at the end: the client gives up after four readings', async () => {
    const { client, timer, run } = bench();
    timer.core.onAnswer = ({ name }) => {
      if (name === 'GETSERVOPOS') timer.core.memory = 1 - timer.core.memory;
    };
    await expect(run(client.readProgram())).rejects.toMatchObject({
      code: 'unstable',
      message: 'not one of 4 readings was undisturbed',
      details: { request: 'GETMEMORY' },
    });
    expect(names(timer.core.answered).filter((name) => name === 'GETSERVOPOS')).toHaveLength(4);
  });

  it('a reading of another memory does not count as a first reading of this one', async () => {
    const { client, timer, run } = await suspicious();
    let left = 2;
    timer.core.onAnswer = ({ name }) => {
      if (name === 'GETSERVOPOS' && --left === 0) timer.core.memory = 1;
    };
    expect(await run(client.readProgram())).toEqual(memoryOf(timer, 1));
  });
});

describe('what an error says of the request', () => {
  it('the content of the reply was impossible each time', async () => {
    const { client, timer, run } = bench();
    answering(timer, 'GETTIMERS', () => [1]);
    await expect(run(client.request({ name: 'GETTIMERS' }))).rejects.toMatchObject({
      code: 'bad-reply',
      message: 'the reply to GETTIMERS cannot be right',
      details: { request: 'GETTIMERS', sent: BAD_REPLIES },
      cause: { code: 'wrong-length' },
    });
  });

  it('a question without an answer before, and a bad one now, is malformed after two tries', async () => {
    const { client, timer, run } = bench({ identity: { timerClass: 'Q' } });
    let isSilent = true;
    answering(timer, 'GETLOWRPM', () => (isSilent ? null : [1, 2]));
    await run(client.readProgram());
    isSilent = false;
    expect((await run(client.readProgram())).idleThrottle).toBeNull();
    expect([...client.quirksFound.keys()]).toEqual(['idle-throttle-unanswered', 'idle-throttle-malformed']);
  });

  it('a timer that falls silent on a line that was damaged before is silent, and the next error comes sooner', async () => {
    const { client, timer, run, line } = await suspicious();
    timer.core.sleep();
    await expect(run(client.readProgram())).rejects.toMatchObject({ code: 'no-answer' });
    line.length = 0;
    await expect(run(client.readProgram())).rejects.toMatchObject({ code: 'no-answer' });
    expect(line).toHaveLength(3);
  });
});

it('a client that is closed asks nothing more, and selects no other memory', async () => {
  const { client, timer, run } = bench({ latency: 50 });
  await run(client.identify());
  timer.core.onAnswer = ({ name }) => {
    if (name === 'GETTIMERS') void client.close();
  };
  const failed = client.readMemories({ memories: [1] }).catch((error: unknown) => error);
  expect(await run(failed)).toMatchObject({ code: 'memory-left', cause: { code: 'closed' } });
  expect(names(timer.core.answered).at(-1)).toBe('GETTIMERS');
});

describe('a selected memory', () => {
  it('is uncertain when the timer does not name it: the job stops, and so does the way back', async () => {
    const { client, timer, run } = bench();
    await run(client.identify());
    answering(timer, 'GETMEMORY', (count) => (count < 2 ? undefined : []));
    const failed = await run(client.readMemories({ memories: [1] }).catch((error: unknown) => error));
    expect(failed).toMatchObject({ code: 'memory-left', details: { expected: 0, found: null } });
    expect(failed).toMatchObject({ cause: { code: 'memory-unknown' } });
    expect(failed).not.toHaveProperty('details.request');
    expect(names(timer.core.answered)).not.toContain('GETTIMERS');
  });

  it('is asked for twice before the first selection, and after each one', async () => {
    const { client, timer, run } = bench();
    await run(client.identify());
    timer.core.answered.length = 0;
    const told: string[] = [];
    await run(
      client.readMemories({
        memories: [1],
        onProgress: ({ stage, done, total }) => told.push(`${stage} ${done}/${total}`),
      }),
    );
    const select = ['GETSWVER', 'SETMEMORY', 'GETSWVER', 'GETMEMORY', 'GETMEMORY'];
    const read = ['GETMEMORY', 'GETTIMERS', 'GETSERVOPOS', 'GETMEMORY', 'GETSWVER'];
    expect(names(timer.core.answered)).toEqual(['GETSWVER', 'GETMEMORY', 'GETMEMORY', ...select, ...read, ...select]);
    const sizes = told.map((text) => text.split(/[ /]/));
    expect(sizes.every(([stage]) => stage === 'read')).toBe(true);
    expect(sizes.at(-1)?.[1]).toBe(sizes.at(-1)?.[2]);
  });
});

const FALLING = [0, 0x0200, 0x0101, 0x0202, 0x0303, 0x0404, 0x0505, 0x0606, 0x0707, 0x0808, 0x0909];

it('times that fall are no hint of their byte order when the high byte is known to come first', async () => {
  const { client, timer, run } = bench({ quirks: { bigEndianTimes: true } }, { quirks: { bigEndianTimes: true } });
  timer.core.content.times = FALLING;
  expect(await run(client.readProgram())).toEqual(contentOf(timer));
  expect([...client.quirksFound.keys()]).toEqual([]);
});
