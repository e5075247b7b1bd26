import { describe, expect, it } from 'vitest';
import { answering, bench, contentOf, memoryOf, names } from './bench.js';

const Q = { identity: { timerClass: 'Q' } };

describe('what a reading is made of', () => {
  it('a whole reading is not repeated when only its end was damaged', async () => {
    let isDamaged = false;
    const fault = (byte: number): number[] => [isDamaged && byte === 0x45 ? 0x44 : byte];
    const { client, timer, run } = bench({ fromTimer: { fault } });
    let memories = 0;
    timer.core.onAnswer = ({ name }) => {
      if (name === 'GETMEMORY') memories++;
      isDamaged = name === 'GETMEMORY' && memories === 2;
    };
    expect(await run(client.readProgram())).toEqual(contentOf(timer));
    expect(names(timer.core.answered).filter((name) => name === 'GETTIMERS')).toHaveLength(2);
  });

  it('the memory is unknown when the timer no longer names it at the end', async () => {
    const { client, timer, run } = bench();
    answering(timer, 'GETMEMORY', (count) => (count === 0 ? undefined : null));
    expect(await run(client.readProgram())).toEqual({ ...contentOf(timer), memory: null });
    expect([...client.quirksFound.keys()]).toEqual(['memory-unknown']);
  });
});

describe('a way through several memories', () => {
  it('through no memories reads nothing', async () => {
    const { client, run } = bench();
    expect(await run(client.readMemories({ memories: [] }))).toEqual({ original: 0, programs: [] });
  });

  it('does not begin when the answer shows that the given numbers are wrong', async () => {
    const { client, timer, run } = bench({ quirks: { memoriesFromOne: true } });
    timer.core.memory = 3;
    await expect(run(client.readMemories({ memories: [1] }))).rejects.toMatchObject({ code: 'memory-unknown' });
    expect(names(timer.core.answered)).not.toContain('SETMEMORY');
  });

  it('gives what a memory holds with the idle throttle where the goal has one', async () => {
    const { client, timer, run } = bench();
    const read: (number | null)[] = [];
    const onMemory = ({ idleThrottle }: { idleThrottle: number | null }): void => void read.push(idleThrottle);
    for (const idleThrottle of [40, null]) {
      await run(client.writeMemories([{ ...memoryOf(timer, 1), idleThrottle }], { onMemory }));
    }
    expect(read).toEqual([30, null]);
  });
});

describe('a memory that is left', () => {
  /** A timer at this memory. */
  const at = (original: number, options = {}) => {
    const made = bench({ ...Q, ...options });
    made.timer.core.memory = original;
    return made;
  };

  it('names no request when another one than the selection was not answered', async () => {
    const { client, timer, run } = at(1);
    timer.core.onAnswer = ({ name }) => {
      if (name === 'GETTIMERS' && timer.core.memory === 2) timer.core.sleep();
    };
    const failure = await run(client.readMemories({ memories: [2] }).catch((error: unknown) => error));
    expect(failure).toMatchObject({ code: 'memory-left', cause: { code: 'no-answer' } });
    expect(failure).toHaveProperty('details', { expected: 1, found: 2 });
  });

  it('names no request when the answer to the selection was damaged', async () => {
    let isDamaged = false;
    let asked = 0;
    const fault = (byte: number): number[] => [isDamaged && byte === 0x45 ? asked % 60 : byte];
    const { client, timer, run } = at(1, { fromTimer: { fault } });
    timer.core.onAnswer = ({ name }) => {
      asked++;
      isDamaged = name === 'SETMEMORY';
    };
    const failure = await run(client.readMemories({ memories: [2] }).catch((error: unknown) => error));
    expect(failure).toMatchObject({
      code: 'memory-left',
      cause: { code: 'unstable', details: { request: 'SETMEMORY' } },
    });
    expect(failure).toHaveProperty('details', { expected: 1, found: null });
  });

  it('sends nothing more when another timer is there', async () => {
    const { client, timer, run } = at(1);
    timer.core.onAnswer = ({ name }) => {
      if (name !== 'GETTIMERS' || timer.core.memory !== 2) return;
      Object.assign(timer.core, { identity: { ...timer.core.identity, timerClass: 'B' } });
      timer.core.answered.length = 0;
    };
    await expect(run(client.readMemories({ memories: [2] }))).rejects.toMatchObject({
      code: 'memory-left',
      cause: { code: 'other-timer' },
    });
    expect(names(timer.core.answered)).toEqual(['GETSERVOPOS', 'GETLOWRPM', 'GETMEMORY', 'GETSWVER', 'GETSWVER']);
  });
});
