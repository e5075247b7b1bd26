import { describe, expect, it } from 'vitest';
import { type MemoriesRead, type MemoriesReport, TimerClient, TimerError } from '../../src/client/index.js';
import type { TimerProgram } from '../../src/program/index.js';
import type { VirtualTimer } from '../../src/simulator/index.js';
import { shareOf } from '../tools/share.js';
import { bench, memoriesOf, memoryOf } from './bench.js';
import { type Direction, type Fault, FieldLine } from './field-line.js';
import { everyValueChanged, FAULTS } from './matrix.js';

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
});
