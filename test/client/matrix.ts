import { expect } from 'vitest';
import { TimerClient, type WriteReport } from '../../src/client/index.js';
import { VirtualClock } from '../../src/line/index.js';
import { changeRequests, partWritten, type TimerProgram } from '../../src/program/index.js';
import { COMMANDS, type CommandName, type Identity } from '../../src/protocol/index.js';
import { VirtualTimer } from '../../src/simulator/index.js';
import { contentOf } from './bench.js';
import { type Direction, type Fault, FieldLine } from './field-line.js';

/** Everything that may happen to a byte. The place of the byte decides which bit is flipped. */
export const FAULTS: Readonly<Record<string, (index: number) => Fault>> = {
  lost: () => ({ bytes: () => [] }),
  'one bit flipped': (index) => ({ bytes: (byte) => [byte ^ (1 << (index % 8))] }),
  'all bits flipped': () => ({ bytes: (byte) => [byte ^ 0xff] }),
  doubled: () => ({ bytes: (byte) => [byte, byte] }),
  'held up 0.7 s': () => ({ delay: 700 }),
  'held up 1.6 s': () => ({ delay: 1600 }),
  'held up 2.5 s': () => ({ delay: 2500 }),
  'line cut': () => ({ event: 'cut' }),
  'timer asleep': () => ({ event: 'asleep' }),
  'page gone': () => ({ event: 'gone' }),
  'page gone, the rest 0.5 s later': () => ({ event: 'gone', delay: 500 }),
};

const DANGEROUS = ['UNLOCK', 'JUMP2', 'MOVETOFUNC'] as const;

/** A timer in the field, the line to it, and the page that has opened the line. */
class Field {
  readonly clock = new VirtualClock(1_700_000_000_000);
  readonly timer: VirtualTimer;
  readonly line: FieldLine;
  client: TimerClient;
  /** The letters of all frames that any page has sent. */
  readonly sent: number[] = [];
  /** What the timer held at first, and what it shall hold. */
  readonly before: TimerProgram;
  readonly goal: TimerProgram;

  constructor(identity: Partial<Identity>) {
    this.timer = new VirtualTimer({ clock: this.clock, identity, baudRate: 9600, latency: 5 });
    this.line = new FieldLine(this.timer, this.clock);
    this.client = this.openPage();
    this.before = structuredClone(contentOf(this.timer));
    this.goal = everyValueChanged(this.before);
  }

  openPage(): TimerClient {
    const onLine = ({ direction, frame }: { direction: string; frame: { code: number } | null }): void => {
      if (direction === 'out' && frame) this.sent.push(frame.code);
    };
    this.client = new TimerClient(this.line.open(), { clock: this.clock, onLine });
    return this.client;
  }

  run<T>(promise: Promise<T>): Promise<T> {
    return this.clock.run(promise);
  }

  timesSent(name: CommandName): number {
    return this.sent.filter((code) => code === COMMANDS[name].request).length;
  }

  timesAnswered(name: CommandName): number {
    return this.timer.core.answered.filter((request) => request.name === name).length;
  }
}

export function everyValueChanged(program: TimerProgram): TimerProgram {
  return {
    ...program,
    times: program.times.map((time, slot) => time + 301 + slot),
    positions: program.positions.map((row, servo) => row.map((position) => position + 4 + servo)),
    idleThrottle: program.idleThrottle === null ? null : program.idleThrottle + 7,
  };
}

/** One thing that a page does with a timer. */
interface Act {
  /** What was done before, without faults. */
  readonly prepare: (client: TimerClient) => Promise<unknown>;
  readonly act: (client: TimerClient, field: Field) => Promise<unknown>;
}

const ACTS: Readonly<Record<'connect' | 'read' | 'write' | (typeof DANGEROUS)[number], Act>> = {
  connect: { prepare: async () => {}, act: (client) => client.identify() },
  read: { prepare: (client) => client.identify(), act: (client) => client.readProgram() },
  write: {
    prepare: (client) => client.readProgram(),
    act: (client, { before, goal }) => client.writeProgram(goal, { baseline: before }),
  },
  UNLOCK: { prepare: (client) => client.identify(), act: (client) => client.unlockMotor() },
  JUMP2: { prepare: (client) => client.identify(), act: (client) => client.jump() },
  MOVETOFUNC: { prepare: (client) => client.identify(), act: (client) => client.moveToFunction(1) },
};

type ActName = keyof typeof ACTS;

interface Case {
  readonly identity: Partial<Identity>;
  readonly act: ActName;
  readonly direction: Direction;
  /** The byte with the fault, counted from the beginning of the act. */
  readonly index: number;
  readonly fault: keyof typeof FAULTS;
}

/** How many bytes an act takes in each direction without faults. */
async function bytesOf(identity: Partial<Identity>, name: ActName): Promise<Record<Direction, number>> {
  const field = new Field(identity);
  const { prepare, act } = ACTS[name];
  await field.run(prepare(field.client));
  const before = field.line.counts;
  await field.run(act(field.client, field));
  const after = field.line.counts;
  return { out: after.out - before.out, in: after.in - before.in };
}

/** Every byte of an act, in both directions, with every fault. */
export async function allCases(identity: Partial<Identity>, act: ActName): Promise<Case[]> {
  const bytes = await bytesOf(identity, act);
  return (['out', 'in'] as const).flatMap((direction) =>
    Array.from({ length: bytes[direction] }, (_, index) => index).flatMap((index) =>
      Object.keys(FAULTS).map((fault) => ({ identity, act, direction, index, fault })),
    ),
  );
}

/**
 * Lets a case happen, then brings the field in order: the timer awake, the line open, with a new page if the old one
 * has gone.
 */
async function happen(hit: Case): Promise<{ field: Field; result: unknown }> {
  const { identity, act: name, direction, index, fault } = hit;
  const field = new Field(identity);
  const { prepare, act } = ACTS[name];
  await field.run(prepare(field.client));
  const befalling = (FAULTS[fault] as (index: number) => Fault)(index);
  const { event } = befalling;
  field.line.arm(direction, index, befalling);
  const acting = act(field.client, field).catch((error: unknown) => error);
  const result = await field.run(event === 'gone' ? field.line.lost : acting);
  expect(field.line.isArmed, `the fault has not happened: ${label(hit)}`).toBe(false);
  field.timer.core.press();
  if (event === 'gone' || event === 'cut') field.openPage();
  return { field, result };
}

/** Whether only a new start can go on after this fault. */
function isEnd({ fault, index }: Case): boolean {
  return FAULTS[fault]?.(index).event !== undefined;
}

function label({ act, direction, index, fault }: Case): string {
  return `${act}, byte ${index} ${direction}, ${fault}`;
}

/**
 * What must hold for a read or a write with any one fault: nothing untrue is said, and the work can go on from there.
 * @param aim what is written afterwards: the goal once more, or the backup.
 */
export async function holds(hit: Case, aim: 'goal' | 'before'): Promise<void> {
  const { field, result } = await happen(hit);
  const { timer, before, goal } = field;
  const { core } = timer;
  const text = label(hit);
  const said = result as Partial<WriteReport & TimerProgram> | undefined;
  if (said?.result === 'verified') expect(contentOf(timer), text).toEqual(goal);
  if (said?.times) expect(said, text).toEqual(contentOf(timer));
  // A single fault that leaves line, page and timer in place is overcome at once.
  if (hit.act !== 'connect' && !isEnd(hit))
    expect(said?.result ?? said?.times, text).toEqual(said?.times ?? 'verified');

  const held = await field.run(field.client.readProgram());
  expect(held, text).toEqual(contentOf(timer));
  expect(partWritten(before, goal, held).extent, text).not.toBe('foreign');
  const wanted = aim === 'goal' ? goal : before;
  const report = await field.run(field.client.writeProgram(wanted, { baseline: held }));
  expect(report, text).toMatchObject({ result: 'verified', stopped: null });
  expect(contentOf(timer), text).toEqual(wanted);

  // No damaged request was taken for another one.
  const asked = new Set(
    [...changeRequests(before, goal), ...changeRequests(held, wanted)].map((r) => JSON.stringify(r)),
  );
  for (const request of core.answered) {
    if (request.name.startsWith('SET')) expect(asked, text).toContain(JSON.stringify(request));
  }
  for (const name of DANGEROUS) expect([field.timesSent(name), field.timesAnswered(name)], text).toEqual([0, 0]);
}

/** What must hold for a dangerous command with any one fault: it went out once, and was carried out once at most. */
export async function wentOutOnce(hit: Case): Promise<void> {
  const { field } = await happen(hit);
  // By then everything has come, and the page has gone on.
  await field.clock.advance(10_000);
  await field.run(field.client.readProgram());
  for (const name of DANGEROUS) {
    expect(field.timesSent(name), `a dangerous request went out too often: ${label(hit)}`).toBe(
      name === hit.act ? 1 : 0,
    );
    expect(
      field.timesAnswered(name),
      `a dangerous request was carried out too often: ${label(hit)}`,
    ).toBeLessThanOrEqual(name === hit.act ? 1 : 0);
  }
}
