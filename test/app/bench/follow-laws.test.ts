import fc from 'fast-check';
import { afterEach, expect, it, vi } from 'vitest';
import { setValues } from '../../../src/app/editing/edit.js';
import { COMMANDS } from '../../../src/protocol/index.js';
import type { TimerQuirks } from '../../../src/simulator/index.js';
import { type AppBench, connectedBench, idle } from './bench.js';

afterEach(() => localStorage.clear());

/** What a pilot, his timer and his cable may do, each followed by some milliseconds. */
type Act =
  | { readonly do: 'edit'; readonly servo: number; readonly slots: readonly number[]; readonly value: number }
  | { readonly do: 'type'; readonly servo: number; readonly slot: number; readonly text: string }
  | { readonly do: 'move' | 'bring'; readonly slot: number }
  | { readonly do: 'safe'; readonly on: boolean }
  | { readonly do: 'deaf'; readonly answers: number }
  | { readonly do: 'select'; readonly memory: number }
  | {
      readonly do:
        | 'undo'
        | 'time'
        | 'follow'
        | 'stop'
        | 'hide'
        | 'unplug'
        | 'replug'
        | 'sleep'
        | 'press'
        | 'jump'
        | 'unlock'
        | 'read'
        | 'write';
    };

const slot = fc.integer({ min: 0, max: 10 });
const servo = fc.nat(2);
const value = fc.nat(130);
const few = fc.constantFrom(3, 4, 5);
const act: fc.Arbitrary<Act> = fc.oneof(
  {
    arbitrary: fc.record({ do: fc.constant('edit' as const), servo, slots: few.map((at) => [at]), value }),
    weight: 8,
  },
  fc.record({ do: fc.constant('edit' as const), servo, slots: fc.uniqueArray(slot, { minLength: 1 }), value }),
  fc.record({ do: fc.constant('type' as const), servo, slot: few, text: value.map(String) }),
  { arbitrary: fc.record({ do: fc.constantFrom('move' as const, 'bring' as const), slot: few }), weight: 4 },
  fc.record({ do: fc.constant('safe' as const), on: fc.constantFrom(true, true, true, false) }),
  fc.record({ do: fc.constant('deaf' as const), answers: fc.integer({ min: 1, max: 4 }) }),
  fc.record({ do: fc.constant('select' as const), memory: fc.nat(1) }),
  { arbitrary: fc.constant<Act>({ do: 'follow' }), weight: 4 },
  fc
    .constantFrom(
      ...(['undo', 'time', 'stop', 'hide', 'unplug', 'replug', 'press'] as const),
      ...(['sleep', 'jump', 'unlock', 'read', 'write'] as const),
    )
    .map((name): Act => ({ do: name })),
);
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

function perform(app: AppBench, act: Act, lose: (answers: number) => void): void {
  const { editor, session, bench, follow, write, timer, adapter } = app;
  const position = (servo: number, slot: number) => ({ kind: 'position' as const, servo, slot });
  if (act.do === 'edit') {
    const values = act.slots.map((slot) => ({ field: position(act.servo, slot), value: act.value }));
    editor.apply(setValues({ code: 'change', params: {} }, values));
  } else if (act.do === 'type') editor.type(position(act.servo, act.slot), act.text);
  else if (act.do === 'undo') editor.undo();
  else if (act.do === 'time') {
    const values = [{ field: { kind: 'time', slot: 10 } as const, value: 20_000 }];
    editor.apply(setValues({ code: 'change', params: {} }, values));
  } else if (act.do === 'move') void bench.moveTo(act.slot);
  else if (act.do === 'bring') follow.bring(act.slot);
  else if (act.do === 'safe') act.on ? session.safety.confirm() : session.safety.withdraw();
  else if (act.do === 'deaf') lose(act.answers);
  else if (act.do === 'select') void session.reader.selectMemory(act.memory);
  else if (act.do === 'follow') void follow.start();
  else if (act.do === 'stop') void follow.stop();
  else if (act.do === 'hide') void follow.stop('over');
  else if (act.do === 'unplug' && adapter.port.connected) adapter.unplug();
  else if (act.do === 'replug' && !adapter.port.connected) adapter.replug();
  else if (act.do === 'sleep') timer.core.sleep();
  else if (act.do === 'press') timer.core.press();
  else if (act.do === 'jump') void bench.jump();
  else if (act.do === 'unlock') void bench.unlock();
  else if (act.do === 'read') void session.reader.read();
  else if (act.do === 'write') void write.open().then(() => write.dismiss());
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
        perform(app, act, lose);
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
