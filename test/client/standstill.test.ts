import { describe, expect, it } from 'vitest';
import { TimerClient, TimerError, type WriteReport } from '../../src/client/index.js';
import { StandstillWatch } from '../../src/client/standstill.js';
import { type Clock, VirtualClock } from '../../src/line/index.js';
import type { TimerProgram } from '../../src/program/index.js';
import { VirtualTimer } from '../../src/simulator/index.js';
import { bench, contentOf, edited } from './bench.js';
import { FRESH, Head, SETS, SMALL, VERIFY } from './head.js';
import { everyValueChanged } from './matrix.js';

describe('the watch for standstills', () => {
  /** The clock of a program, and a clock on the wall that is an hour ahead. */
  function clocks() {
    const at = { own: 5000, wall: 3_605_000 };
    const clock: Clock = { now: () => at.own, after: () => () => {}, wall: () => at.wall };
    return { at, watch: new StandstillWatch(clock) };
  }

  it('counts what comes more than ten seconds late', () => {
    const { watch } = clocks();
    watch.noteDue(-5000);
    expect(watch.count, 'ten seconds are not more').toBe(0);
    watch.noteDue(-5001);
    watch.noteDue(-5001);
    expect(watch.count).toBe(2);
  });

  it('counts a jump of the clock on the wall by more than ten seconds, and its log follows the jump', () => {
    const { at, watch } = clocks();
    expect(watch.time).toBe(3_605_000);
    at.wall += 10_000;
    expect([watch.count, watch.time]).toEqual([0, 3_605_000]);
    at.wall += 10_001;
    expect([watch.count, watch.time]).toEqual([1, 3_615_001]);
    at.own += 10_001;
    at.wall += 10_001;
    expect([watch.count, watch.time], 'both go on').toEqual([1, 3_625_002]);
  });
});

/** A page that stands still for a while, as when the lid of a laptop is closed. The timer and its adapter do not. */
class StillPage extends Head implements Clock {
  /** The request, counted from 1, after which it stands still. */
  stopAt = Number.POSITIVE_INFINITY;
  stopFor = 0;
  /** What happens meanwhile. */
  meanwhile = (): void => {};
  readonly #clock: VirtualClock;
  readonly #bytesFirst: boolean;
  #due: (() => void)[] | null = null;
  #came: Uint8Array[] = [];

  constructor(clock: VirtualClock, bytesFirst: boolean, ...timers: ConstructorParameters<typeof Head>) {
    super(...timers);
    this.#clock = clock;
    this.#bytesFirst = bytesFirst;
    this.asked = () => {
      if (this.requests === this.stopAt) this.#stop();
    };
  }

  protected override hear(bytes: Uint8Array): void {
    if (this.#due) this.#came.push(bytes);
    else this.deliver(bytes);
  }

  now(): number {
    return this.#clock.now();
  }

  after(ms: number, callback: () => void): () => void {
    let gone = false;
    const act = (): void => {
      if (this.#due) this.#due.push(act);
      else if (!gone) callback();
    };
    const cancel = this.#clock.after(ms, act);
    return () => {
      gone = true;
      cancel();
    };
  }

  #stop(): void {
    this.#due = [];
    this.#clock.after(this.stopFor / 2, () => this.meanwhile());
    this.#clock.after(this.stopFor, () => {
      const due = this.#due ?? [];
      const came = this.#came.splice(0);
      this.#due = null;
      const bytes = (): void => {
        for (const each of came) this.deliver(each);
      };
      const all = (): void => {
        for (const act of due) act();
      };
      const [now, then] = this.#bytesFirst ? [bytes, all] : [all, bytes];
      now();
      this.#clock.after(1, then);
    });
  }
}

/** Confirms a write, and lets the page stand still in the middle of it. */
async function written({ at, ms, bytesFirst, swap = false }: Standstill) {
  const clock = new VirtualClock();
  const first = new VirtualTimer({ clock, identity: SMALL, latency: 20 });
  const other = new VirtualTimer({ clock, identity: SMALL, latency: 20 });
  Object.assign(other.core.content, everyValueChanged(contentOf(other)));
  const page = new StillPage(clock, bytesFirst, first, other);
  const client = new TimerClient(page, { clock: page });
  const baseline = await clock.run(client.readProgram());
  const goal: TimerProgram = edited(baseline, [2, 9000], [0, 1, 77]);
  page.requests = 0;
  page.stopAt = at;
  page.stopFor = ms;
  page.meanwhile = () => {
    if (swap) page.at = other;
  };
  const writing = client.writeProgram(goal, { baseline }).catch((error: unknown) => error);
  const result = (await clock.run(writing)) as Partial<WriteReport> & { code?: string };
  return { clock, client, first, other, goal, page, result };
}

interface Standstill {
  /** The request after which the page stands still, counted from 1, and for how long. */
  readonly at: number;
  readonly ms: number;
  /** Whether the page first hears what came meanwhile, or first does what was due. */
  readonly bytesFirst: boolean;
  /** Whether another timer is under the head afterwards. */
  readonly swap?: boolean;
}

/** After the last request nothing more has to be sent. */
const CASES = Array.from({ length: FRESH + SETS + VERIFY - 1 }, (_, index) => index + 1).flatMap((at) =>
  [true, false].map((bytesFirst) => ({ at, bytesFirst })),
);

describe('a page that stands still during a write', () => {
  it.each(CASES)('for a minute, after request $at, bytes first: $bytesFirst, sends nothing more', async (each) => {
    for (const swap of [false, true]) {
      const { clock, client, first, other, goal, page, result } = await written({ ...each, ms: 60_000, swap });
      const before = everyValueChanged(contentOf(new VirtualTimer({ clock, identity: SMALL })));
      expect([page.requests, result.code ?? result.stopped?.code]).toEqual([each.at, 'stood-still']);
      expect(client.standstills).toBeGreaterThan(0);
      // Before the first SET the write does not begin; later nobody knows.
      expect(result.result).toBe(each.at <= FRESH ? undefined : 'unknown');
      expect(contentOf(other)).toEqual(before);
      // The next job works as ever.
      page.at = first;
      const held = await clock.run(client.readProgram());
      expect(held).toEqual(contentOf(first));
      expect(await clock.run(client.writeProgram(goal, { baseline: held }))).toMatchObject({ result: 'verified' });
      expect(contentOf(first)).toEqual(goal);
    }
  });

  it.each(CASES)('for up to ten seconds, after request $at, bytes first: $bytesFirst, goes on', async (each) => {
    for (const ms of [2000, 9990]) {
      const { client, first, goal, result } = await written({ ...each, ms });
      expect(result, `for ${ms} ms`).toMatchObject({ result: 'verified', stopped: null });
      expect(client.standstills, `for ${ms} ms`).toBe(0);
      expect(contentOf(first)).toEqual(goal);
    }
  });
});

describe('a computer that sleeps, and whose clock for programs sleeps, too', () => {
  /** A write of two values; after the request `at` the computer sleeps for `ms` milliseconds. */
  async function slept(at: number, ms: number) {
    const clock = new VirtualClock();
    const timer = new VirtualTimer({ clock, identity: SMALL, latency: 20 });
    let asleep = 0;
    const port = new Head(timer);
    const sleepy: Clock = {
      now: () => clock.now(),
      after: (after, callback) => clock.after(after, callback),
      wall: () => clock.now() + asleep,
    };
    const times: number[] = [];
    const client = new TimerClient(port, { clock: sleepy, onLine: ({ time }) => void times.push(time) });
    const baseline = await clock.run(client.readProgram());
    const goal = edited(baseline, [2, 9000], [0, 1, 77]);
    port.requests = 0;
    port.asked = () => {
      if (port.requests === at) asleep += ms;
    };
    const writing = client.writeProgram(goal, { baseline }).catch((error: unknown) => error);
    const result = (await clock.run(writing)) as Partial<WriteReport> & { code?: string };
    return {
      clock,
      client,
      timer,
      goal,
      result,
      requests: port.requests,
      times,
      sleep: (more: number) => (asleep += more),
    };
  }

  it.each(Array.from({ length: FRESH + SETS + VERIFY - 1 }, (_, index) => index + 1))(
    'for a minute after request %d sends nothing more, and the next job works',
    async (at) => {
      const { clock, client, timer, goal, result, requests } = await slept(at, 60_000);
      expect([requests, result.code ?? result.stopped?.code]).toEqual([at, 'stood-still']);
      const held = await clock.run(client.readProgram());
      expect(await clock.run(client.writeProgram(goal, { baseline: held }))).toMatchObject({ result: 'verified' });
      expect(contentOf(timer)).toEqual(goal);
    },
  );

  it.each([2000, -3_600_000])('for %d ms, or whose clock is put back, goes on', async (ms) => {
    const { timer, goal, result } = await slept(FRESH + 1, ms);
    expect(result).toMatchObject({ result: 'verified', stopped: null });
    expect(contentOf(timer)).toEqual(goal);
  });

  it('wherever it sleeps, the error says which request was in progress, and whether it went out', async () => {
    const sents = new Set<number | undefined>();
    for (let sleepsAt = 1; sleepsAt < 200; sleepsAt++) {
      const clock = new VirtualClock();
      const timer = new VirtualTimer({ clock, identity: SMALL, latency: 20 });
      let looks = Number.NEGATIVE_INFINITY;
      const client = new TimerClient(timer, {
        clock: {
          now: () => clock.now(),
          after: (after, callback) => clock.after(after, callback),
          wall: () => clock.now() + (++looks > sleepsAt ? 60_000 : 0),
        },
      });
      await clock.run(client.identify());
      looks = 0;
      const error = await clock.run(client.readProgram().catch((failure: unknown) => failure as TimerError));
      if (!(error instanceof TimerError)) break;
      expect(error.code).toBe('stood-still');
      expect(error.details.request).toMatch(/^GET/);
      sents.add(error.details.sent);
    }
    expect(sents, 'before and after a request').toEqual(new Set([0, 1]));
  });

  it('between two jobs is nothing to the second one, and counts in the log', async () => {
    const { clock, client, timer, times, sleep } = await slept(0, 0);
    const before = times.at(-1) ?? Number.NaN;
    times.length = 0;
    sleep(3_600_000);
    expect(await clock.run(client.readProgram())).toEqual(contentOf(timer));
    expect((times[0] ?? 0) - before).toBe(3_600_000);
  });
});

describe('a page that stands still', () => {
  it('while memories are read leaves the timer as it is, and says that another memory may be current', async () => {
    const clock = new VirtualClock();
    const timer = new VirtualTimer({ clock, identity: SMALL, latency: 20 });
    const page = new StillPage(clock, true, timer);
    const client = new TimerClient(page, { clock: page });
    await clock.run(client.identify());
    // The question behind the first SETMEMORY.
    page.stopAt = 12;
    page.stopFor = 60_000;
    const error = await clock.run(client.readMemories().catch((failure: unknown) => failure));
    expect(error).toMatchObject({ code: 'memory-left', cause: { code: 'stood-still' }, details: { expected: 0 } });
    expect(page.requests).toBe(page.stopAt);
    await clock.run(client.selectMemory(0));
    expect(timer.core.memory).toBe(0);
  });

  it.each([true, false])('behind a command says that it was sent, bytes first: %s', async (bytesFirst) => {
    const clock = new VirtualClock();
    const timer = new VirtualTimer({ clock, identity: { ...SMALL, timerClass: 'Q' }, latency: 20 });
    const page = new StillPage(clock, bytesFirst, timer);
    const client = new TimerClient(page, { clock: page });
    await clock.run(client.identify());
    for (const [act, request] of [
      [() => client.unlockMotor(), 'UNLOCK'],
      [() => client.setPosition({ servo: 0, slot: 1 }, 5), 'SETSERVO'],
    ] as const) {
      page.stopAt = page.requests + 1;
      page.stopFor = 60_000;
      const error = await clock.run(act().catch((failure: unknown) => failure));
      // An answer that came meanwhile is an answer.
      if (bytesFirst) expect(error).toBeUndefined();
      else expect(error).toMatchObject({ code: 'stood-still', details: { request, sent: 1 } });
      expect(page.requests).toBe(page.stopAt);
    }
  });

  it('between two jobs is nothing to the second one', async () => {
    const { clock, timer, client } = bench();
    await clock.run(client.readProgram());
    await clock.advance(3_600_000);
    expect(await clock.run(client.readProgram())).toEqual(contentOf(timer));
  });
});
