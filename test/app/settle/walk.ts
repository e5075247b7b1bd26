import { choicesOf, type Said } from '../../../src/app/settle/conclusions.js';
import { Settle } from '../../../src/app/settle/settle.js';
import type { Step } from '../../../src/app/settle/steps.js';
import type { Answers } from '../../../src/app/storage/records.js';
import type { Identity } from '../../../src/protocol/index.js';
import type { TimerQuirks } from '../../../src/simulator/index.js';
import { type AppBench, idle, run } from '../bench/bench.js';

/** Somebody who looks at the timer and its handheld. */
export interface Person {
  /** The questions that are answered. Default: all. */
  readonly knows?: readonly (keyof Said)[];
  /** Answers in place of the right ones. */
  readonly says?: Said;
}

/** A walk before its first step, with the tick that no propeller can turn. */
export function walkOn({ session, bench }: AppBench): Settle {
  const settle = new Settle(session, bench);
  settle.saySafe(true);
  return settle;
}

/** Does all steps, or those before one. */
export async function walk(
  app: AppBench,
  settle: Settle,
  { knows, says = {} }: Person = {},
  until: Step['name'] = 'end',
): Promise<Settle> {
  for (let left = 20; settle.step.value.name !== until && left > 0; left--) {
    const { name, act, asks } = settle.step.value;
    const { slot } = settle;
    if (slot !== null) await run(app.bench.moveTo(slot));
    const hasMoved = watchServos(app);
    if (act) await run(settle.act());
    await idle(0);
    const moved = hasMoved();
    if (asks && settle.isDone.value) {
      const answers: Said = { ...seenOnHandheld(app, settle), away: moved, there: moved, ...says };
      settle.answer(asks, (knows ?? [asks]).includes(asks) ? (answers[asks] ?? null) : null);
    } else if (settle.step.value.name === name) settle.next();
  }
  return settle;
}

function seenOnHandheld({ timer: { core } }: AppBench, settle: Settle): Said {
  const { functions } = core.identity;
  const slots = [Math.floor(functions / 2), functions];
  const right = String(slots.map((slot) => core.content.times[slot]));
  const choices = choicesOf(slots.map((slot) => settle.seen.value?.times[slot] as number));
  const times = choices.find(({ shown }) => String(shown) === right)?.ways;
  return { ...(times && { times }), count: 'launch', memory: core.memory + 1 };
}

/** @returns a function that says whether a servo has moved since, and ends the watch. */
function watchServos({ timer: { core } }: AppBench): () => boolean {
  const before = String(core.servos);
  const { onAnswer } = core;
  let moved = false;
  core.onAnswer = (request) => {
    moved ||= String(core.servos) !== before;
    onAnswer?.(request);
  };
  return () => {
    core.onAnswer = onAnswer;
    return moved;
  };
}

/** What is true of a virtual timer, of all that can be settled. */
export function truth({ timerClass }: Pick<Identity, 'timerClass'>, quirks: TimerQuirks): Answers {
  const { setMoves = 'there' } = quirks;
  return {
    order: quirks.bigEndianTimes ? 'high-first' : 'low-first',
    unit: 'hundredths',
    count: 'launch',
    memories: quirks.memoryReplyEmpty ? 'unnumbered' : quirks.memoriesFromOne ? 'from-1' : 'from-0',
    layout: quirks.servoFirst ? 'servo-first' : 'function-first',
    // Nothing shows which order a timer takes that keeps nothing.
    ...(!quirks.servoIgnored && { stores: quirks.servoNeedsMove ? 'there' : 'anywhere', moves: setMoves }),
    zeros: 'answered',
    ...(timerClass === 'Q' && { unlock: quirks.unlockReplyAs6A ? '6A' : '6E' }),
  };
}

/** The answers but for what is only measured. */
export function judged({ delay: _, reserved: __, ...answers }: Answers): Answers {
  return answers;
}

/** The same times in their order. */
export function rises(times: readonly number[]): number[] {
  return [...times].sort((a, b) => a - b);
}
