import fc from 'fast-check';
import { expect, it, vi } from 'vitest';
import type { ProgramField } from '../../../src/program/index.js';
import { COMMANDS } from '../../../src/protocol/index.js';
import type { TimerQuirks } from '../../../src/simulator/index.js';
import { type AppBench, connectedBench, idle, set } from './bench.js';

const position = (servo: number, slot: number) => ({ kind: 'position' as const, servo, slot });

/** What a pilot, his timer and his cable may do. @param lose loses the next answers. */
const ACTS = {
  edit: (app: AppBench, { servo, slot, value }: Act) => set(app, [position(servo, slot), value]),
  editMany: (app: AppBench, { servo, slots, value }: Act) =>
    set(app, ...slots.map((slot): [ProgramField, number] => [position(servo, slot), value])),
  type: ({ editor }: AppBench, { servo, slot, value }: Act) => editor.type(position(servo, slot), String(value)),
  move: ({ bench }: AppBench, { slot }: Act) => void bench.moveTo(slot),
  bring: ({ follow }: AppBench, { slot }: Act) => follow.bring(slot),
  safe: ({ session: { safety } }: AppBench, { on }: Act) => (on ? safety.confirm() : safety.withdraw()),
  deaf: (_: AppBench, { answers }: Act, lose: (answers: number) => void) => lose(answers),
  select: ({ session }: AppBench, { memory }: Act) => void session.reader.selectMemory(memory),
  follow: ({ follow }: AppBench) => void follow.start(),
  undo: ({ editor }: AppBench) => editor.undo(),
  time: (app: AppBench) => set(app, [{ kind: 'time', slot: 10 }, 20_000]),
  stop: ({ follow }: AppBench) => void follow.stop(),
  hide: ({ follow }: AppBench) => void follow.stop('over'),
  unplug: ({ adapter }: AppBench) => adapter.port.connected && adapter.unplug(),
  replug: ({ adapter }: AppBench) => adapter.port.connected || adapter.replug(),
  sleep: ({ timer }: AppBench) => timer.core.sleep(),
  press: ({ timer }: AppBench) => timer.core.press(),
  jump: ({ bench }: AppBench) => void bench.jump(),
  unlock: ({ bench }: AppBench) => void bench.unlock(),
  read: ({ session }: AppBench) => void session.reader.read(),
  write: ({ write }: AppBench) => void write.open().then(() => write.dismiss()),
};

/** What is done, and how, as far as that matters. */
interface Act {
  readonly do: keyof typeof ACTS;
  readonly servo: number;
  readonly slot: number;
  readonly slots: readonly number[];
  readonly value: number;
  readonly on: boolean;
  readonly answers: number;
  readonly memory: number;
}

const act: fc.Arbitrary<Act> = fc.record({
  do: fc.oneof(
    { arbitrary: fc.constant('edit' as const), weight: 8 },
    { arbitrary: fc.constantFrom('move' as const, 'bring' as const), weight: 4 },
    { arbitrary: fc.constant('follow' as const), weight: 4 },
    { arbitrary: fc.constantFrom(...(['editMany', 'type', 'safe', 'deaf', 'select'] as const)), weight: 5 },
    fc.constantFrom(...(Object.keys(ACTS) as (keyof typeof ACTS)[])),
  ),
  servo: fc.nat(2),
  slot: fc.constantFrom(3, 4, 5),
  slots: fc.uniqueArray(fc.integer({ min: 0, max: 10 }), { minLength: 1 }),
  value: fc.nat(130),
  on: fc.constantFrom(true, true, true, false),
  answers: fc.integer({ min: 1, max: 4 }),
  memory: fc.nat(1),
});
const step = fc.record({ act, ms: fc.constantFrom(0, 10, 30, 70, 700, 5000) });
const setMoves = fc.constantFrom<NonNullable<TimerQuirks['setMoves']>>('never', 'there', 'always');

/**
 * Judges each movement on the wire by what the pilot has done, as the pilot would: it knows nothing of how the page
 * decides.
 */
class Judge {
  /** A click on the bench, which holds now or never. */
  #moved: number | null = null;
  /** A click under a row, until the servos no longer follow. */
  #brought: number | null = null;
  #safe = true;
  /** Where a movement was acknowledged, with nothing since that could have moved the servos. */
  #at: number | null = null;
  #asked: { readonly code: number; readonly slot: number } | null = null;
  #stored = false;
  #seen = 0;

  constructor(app: AppBench) {
    this.#seen = app.session.log.newest.value;
  }

  /** @param isOn whether the page says that the servos follow. */
  acts(act: Act, isOn: boolean): void {
    this.#moved = act.do === 'move' ? act.slot : null;
    if (act.do === 'bring' && isOn) this.#brought = act.slot;
    if (act.do === 'safe') this.#safe = act.on;
    if (['stop', 'hide', 'unplug'].includes(act.do) || !this.#safe) this.ends();
  }

  /** The servos no longer follow, as the page says. */
  ends(): void {
    this.#brought = null;
  }

  judges({ session }: AppBench): void {
    const entries = session.log.entries.value.filter(({ number }) => number > this.#seen);
    this.#seen = session.log.newest.value;
    for (const { direction, frame } of entries) {
      if (!frame) continue;
      const { code, data } = frame;
      const asked = this.#asked;
      if (direction === 'in') {
        if (asked && code === asked.code + 1) {
          if (asked.code === COMMANDS.MOVETOFUNC.request) this.#at = asked.slot;
          if (asked.code === COMMANDS.SETSERVO.request) this.#stored = asked.slot === this.#at;
        }
        continue;
      }
      if (code === COMMANDS.MOVETOFUNC.request) this.#explains(data[0] as number);
      const slot = data[0] ?? -1;
      // Fences and readings in between move nothing.
      if ((code - 0x61) % 2 === 0) this.#asked = { code, slot };
      if ([COMMANDS.MOVETOFUNC.request, COMMANDS.JUMP2.request, COMMANDS.UNLOCK.request].includes(code as never)) {
        this.#at = null;
        this.#stored = false;
      }
    }
  }

  #explains(slot: number): void {
    expect(this.#safe, `the servos moved to function ${slot} although nobody had said that it is safe`).toBe(true);
    const isAgain = this.#stored && this.#at === slot;
    const why = { isAgain, moved: this.#moved === slot, brought: this.#brought === slot };
    expect(Object.values(why).some(Boolean), `the servos moved to function ${slot} although nobody asked for it`).toBe(
      true,
    );
    if (isAgain) return;
    // One click, one movement.
    if (why.moved) this.#moved = null;
    else this.#brought = null;
  }
}

/** Replies that get lost on their way, though the timer has done what it was told. */
function losing({ timer: { core } }: AppBench): (answers: number) => void {
  let left = 0;
  const answer = core.answer.bind(core);
  core.answer = (...args) => {
    const reply = answer(...args);
    return left-- > 0 ? undefined : reply;
  };
  return (answers) => {
    left = answers;
  };
}

it('every movement on the wire comes from a click, and the servos stand where the page says', async () => {
  await fc.assert(
    fc.asyncProperty(fc.array(step, { minLength: 5, maxLength: 40 }), setMoves, async (steps, moves) => {
      localStorage.clear();
      const app = await connectedBench({ latency: 20, quirks: { setMoves: moves } });
      app.session.safety.confirm();
      const lose = losing(app);
      const judge = new Judge(app);
      let { value: connection } = app.session.connection;
      let wasOn = false;
      for (const { act, ms } of steps) {
        judge.acts(act, app.follow.on.value);
        ACTS[act.do](app, act, lose);
        await vi.advanceTimersByTimeAsync(ms);
        judge.judges(app);
        const isOn = app.follow.on.value;
        if ((wasOn && !isOn) || app.session.connection.value !== connection) judge.ends();
        wasOn = isOn;
        connection = app.session.connection.value;
        const at = app.bench.stand.at.value;
        if (at === null || app.session.runner.busy.value) continue;
        const { core } = app.timer;
        expect([at, core.servos]).toEqual([core.slot, core.content.positions.map((row) => row[at])]);
      }
      void app.follow.stop();
      await idle();
      judge.judges(app);
      if (app.session.connection.value) {
        expect(app.editor.baseline.value?.positions).toEqual(app.timer.core.content.positions);
      }
    }),
    { numRuns: 100 },
  );
});
