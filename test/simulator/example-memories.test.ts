import { describe, expect, it } from 'vitest';
import { checkProgram, type TimerProgram } from '../../src/program/index.js';
import { exampleMemories, type MemoryContent, VirtualTimer } from '../../src/simulator/index.js';

const CLASSES = ['Q', 'B', 'E'] as const;
/** The flight for a test has a short DT, as it has to. */
const TEST_FLIGHT = 2;

const programsOf = (timerClass: 'Q' | 'B' | 'E'): TimerProgram[] => {
  const { core } = new VirtualTimer({ identity: { timerClass }, memories: exampleMemories(timerClass) });
  return core.memories.map((content, memory) => ({ identity: core.identity, memory, ...content, idleThrottle: null }));
};

describe.each(CLASSES)('the memories of a flown F1%s', (timerClass) => {
  const programs = programsOf(timerClass);

  it('keep to the rules of the class: only the DT of the test flight is unusual', () => {
    expect(programs.map((program) => checkProgram(program).map(({ code }) => code))).toEqual(
      programs.map((_, memory) => (memory === TEST_FLIGHT ? ['dt-short'] : [])),
    );
  });

  it('differ as settings of one model do: calm, wind, a test with a DT of 20 s, a fly-off with the longest', () => {
    expect(new Set(programs.map(({ times, positions }) => JSON.stringify([times, positions]))).size).toBe(4);
    const [calm, wind, test, flyOff] = programs.map(({ times }) => times[10] as number);
    expect(test).toBe(2000);
    expect(flyOff).toBeGreaterThan(calm as number);
    expect(wind).toBeLessThanOrEqual(calm as number);
    expect(Math.max(...programs.map(({ times }) => times[10] as number))).toBe(flyOff);
  });
});

describe('the memories of a flown timer', () => {
  it('are copies: each timer changes only its own', () => {
    const memories = exampleMemories('Q');
    const { core } = new VirtualTimer({ identity: { timerClass: 'Q' }, memories });
    (core.memories[0]?.positions[0] as number[])[0] = 1;
    expect(memories[0]?.positions[0]?.[0]).toBe(62);
  });

  it('may be fewer than the timer has: the others are those of a new one', () => {
    const { core } = new VirtualTimer({ identity: { timerClass: 'Q' }, memories: exampleMemories('Q').slice(0, 1) });
    expect(core.memories.map(({ times }) => times[10])).toEqual([18000, 21000, 24000, 27000]);
  });

  it('are refused by a timer of another layout', () => {
    for (const identity of [{ functions: 8 }, { servos: 2 }]) {
      expect(() => new VirtualTimer({ identity, memories: exampleMemories('B') })).toThrow(
        expect.objectContaining({ code: 'wrong-count' }),
      );
    }
  });

  it('are refused at once when no timer could hold them', () => {
    const [memory] = exampleMemories('B') as [MemoryContent];
    const times = memory.times.map(() => 70000);
    const positions = memory.positions.map((row) => row.map(() => Number.NaN));
    const refusal = (content: MemoryContent, code: string) =>
      expect(() => new VirtualTimer({ memories: [content] })).toThrow(expect.objectContaining({ code }));
    refusal({ ...memory, times }, 'out-of-range');
    refusal({ ...memory, positions }, 'not-an-integer');
  });
});
