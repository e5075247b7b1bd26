import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type MemoriesRead, type MemoriesReport, TimerClient, TimerError } from '../../src/client/index.js';
import type { TimerProgram } from '../../src/program/index.js';
import type { VirtualTimer } from '../../src/simulator/index.js';
import { runsOf, shareOf } from '../tools/share.js';
import { bench, memoriesOf, memoryOf } from './bench.js';
import { type Direction, type Fault, FieldLine } from './field-line.js';
import { everyValueChanged, FAULTS } from './matrix.js';
import { damage, numbers } from './noise.js';

/** Whatever is said of memories must be so. */
function expectTruth(
  timer: VirtualTimer,
  result: unknown,
  goals: readonly TimerProgram[],
  original: number,
  text: string,
): void {
  const { stopped, restored, memories } = result as Partial<MemoriesReport>;
  const error = result instanceof TimerError ? result : stopped;
  if (error?.code === 'memory-left') {
    expect(error.details.expected, text).toBe(original);
    const { found } = error.details as { found: number | null };
    if (found !== null) expect(timer.core.memory, text).toBe(found);
  } else {
    expect(timer.core.memory, text).toBe(original);
  }
  if (restored !== undefined) expect(restored, text).toBe(error?.code !== 'memory-left');
  const { programs } = result as Partial<MemoriesRead>;
  for (const program of programs ?? []) expect(program, text).toEqual(memoryOf(timer, program.memory as number));
  for (const { memory, report } of memories ?? []) {
    const goal = goals.find((each) => each.memory === memory);
    if (report.result === 'verified') expect(memoryOf(timer, memory), text).toEqual(goal);
  }
}

describe('several memories on a bad line', () => {
  const jobs: Record<'read' | 'write', (client: TimerClient, goals: readonly TimerProgram[]) => Promise<unknown>> = {
    read: (client) => client.readMemories(),
    write: (client, goals) => client.writeMemories(goals),
  };

  it.each([
    ['read', 4563],
    ['write', 11979],
  ] as const)(
    '%s: whatever fault hits any byte, the first memory is current again, or the error says that it is not: %i cases',
    async (job, count) => {
      const meet = async () => {
        const { clock, timer, run } = bench({ identity: { functions: 2, memories: 2, servos: 1 }, baudRate: 9600 });
        const line = new FieldLine(timer, clock);
        const client = new TimerClient(line.open(), { clock });
        await run(client.identify());
        return { timer, run, line, client, goals: memoriesOf(timer).map(everyValueChanged) };
      };
      const quiet = await meet();
      const begin = quiet.line.counts;
      await quiet.run(jobs[job](quiet.client, quiet.goals));
      const end = quiet.line.counts;
      const cases = (['out', 'in'] satisfies Direction[]).flatMap((direction) =>
        Array.from({ length: end[direction] - begin[direction] }, (_, index) => index).flatMap((index) =>
          Object.entries(FAULTS)
            .map(([name, faultAt]) => ({ direction, index, name, fault: faultAt(index) satisfies Fault }))
            .filter(({ fault }) => fault.event !== 'gone'),
        ),
      );
      expect(cases).toHaveLength(count);
      for (const { direction, index, name, fault } of shareOf(cases)) {
        const { timer, run, line, client, goals } = await meet();
        line.arm(direction, index, fault);
        const result = await run(jobs[job](client, goals).catch((error: unknown) => error));
        expectTruth(timer, result, goals, 0, `${job}, byte ${index} ${direction}, ${name}`);
        if (!fault.event) expect(result, name).not.toBeInstanceOf(Error);
      }
    },
  );

  it('1 % of all bytes damaged: it always succeeds; 5 %: what is reported is true', async () => {
    await fc.assert(
      fc.asyncProperty(
        fc.integer({ min: 0, max: 2 ** 31 }),
        fc.constantFrom(0.01, 0.05),
        fc.constantFrom('read' as const, 'write' as const),
        async (seed, share, job) => {
          const hurt = damage(share, numbers(seed));
          let noisy = false;
          const line = { fault: (byte: number): number[] => (noisy ? hurt(byte) : [byte]) };
          const { client, timer, run } = bench({ baudRate: 9600, toTimer: line, fromTimer: line });
          await run(client.identify());
          noisy = true;
          const goals = memoriesOf(timer).map(everyValueChanged);
          const result = await run(jobs[job](client, goals).catch((error: unknown) => error));
          if (client.damageSeen) expectTruth(timer, result, goals, 0, job);
          if (share > 0.01) return;
          if (job === 'read') expect(result).not.toBeInstanceOf(Error);
          else expect(result).toMatchObject({ restored: true, stopped: null });
        },
      ),
      { numRuns: runsOf(100) },
    );
  });
});
