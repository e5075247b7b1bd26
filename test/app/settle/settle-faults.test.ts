import { expect, it } from 'vitest';
import type { Settle } from '../../../src/app/settle/settle.js';
import type { TimerQuirks } from '../../../src/simulator/index.js';
import { shareOf } from '../../tools/share.js';
import { type AppBench, connectedBench, idle, reloaded, run } from '../bench/bench.js';
import { walk, walkOn } from './walk.js';

const STEPS = ['read', 'zeros', 'away', 'there', 'unlock'] as const;
/** More requests than any step has. */
const MOST = 60;

/** A walk just before the act of a step, and what the timer holds then. */
async function before(step: (typeof STEPS)[number], quirks: TimerQuirks) {
  const app = await connectedBench({ quirks, plug: { granted: true } });
  const settle = await walk(app, walkOn(app), {}, step);
  if (settle.slot !== null) await run(app.bench.moveTo(settle.slot));
  return { app, settle, memories: structuredClone(app.timer.core.memories) };
}

/** Does something when the timer has understood this request of the act. @returns whether there was such a request. */
async function actUntil({ timer: { core } }: AppBench, settle: Settle, request: number, then: () => void) {
  let count = 0;
  let came = false;
  core.onAnswer = () => {
    if (count++ !== request) return;
    came = true;
    then();
  };
  void settle.act();
  await idle();
  core.onAnswer = undefined;
  return came;
}

/** The timer holds what it held, or the page says that something is unfinished. */
function isSaid({ session, timer }: AppBench, memories: unknown): boolean {
  return session.unfinished.value.length > 0 || JSON.stringify(timer.core.memories) === JSON.stringify(memories);
}

/** What was tried is put back by the offer that every interrupted write has. */
async function putBack(app: AppBench, memories: unknown): Promise<void> {
  const { session, timer } = app;
  const offer = session.recovery.offer.value;
  if (offer?.kind !== 'write') {
    expect(JSON.stringify(timer.core.memories), 'something is left, and nothing is offered').toBe(
      JSON.stringify(memories),
    );
    return;
  }
  const { client } = session.connection.value as NonNullable<typeof session.connection.value>;
  const { goal } = offer.record;
  const writeGoal = async () => {
    const baseline = await run(client.readProgram());
    return await run(client.writeProgram(goal, { baseline }));
  };
  let { result } = await writeGoal();
  if (result === 'differs' && client.quirksFound.has('servo-first')) {
    // The page says so, and the pilot ticks it.
    client.assume({ servoFirst: true });
    ({ result } = await writeGoal());
  }
  expect([result, JSON.stringify(timer.core.memories)]).toEqual(['verified', JSON.stringify(memories)]);
}

/** Quirks that change where a position goes or what moves: for the steps that store one. */
const STORES: readonly TimerQuirks[] = [{}, { servoFirst: true }, { setMoves: 'always' }];
const CASES = STEPS.flatMap((step) =>
  (step === 'away' || step === 'there' ? STORES : [{}]).flatMap((quirks) =>
    (['unplugged', 'asleep', 'stopped', 'loaded again'] as const).map((fault) => [fault, step, quirks] as const),
  ),
);

it.each(shareOf(CASES))('%s in the step %s of a timer %o', { timeout: 600_000 }, async (fault, step, quirks) => {
  for (let request = 0; request < MOST; request++) {
    localStorage.clear();
    const { app, settle, memories } = await before(step, quirks);
    const { adapter, session, timer } = app;
    const faults: Record<typeof fault, () => void> = {
      unplugged: () => adapter.unplug(),
      asleep: () => timer.core.sleep(),
      stopped: () => void session.runner.stop(),
      'loaded again': () => adapter.unplug(),
    };
    if (!(await actUntil(app, settle, request, faults[fault]))) return;
    const why = `${fault} at request ${request}`;
    expect(isSaid(app, memories), why).toBe(true);
    if (fault === 'stopped') {
      expect([JSON.stringify(timer.core.memories), session.unfinished.value], why).toEqual([
        JSON.stringify(memories),
        [],
      ]);
      continue;
    }
    if (fault === 'loaded again') {
      const after = await reloaded(app);
      expect(isSaid({ ...after, timer }, memories), why).toBe(true);
      await run(after.session.timer.connect());
      expect(isSaid(after, memories), why).toBe(true);
      await putBack(after, memories);
      continue;
    }
    timer.core.press();
    if (fault === 'unplugged') adapter.replug();
    await idle();
    if (!session.connection.value) await run(session.timer.connect());
    expect(isSaid(app, memories), why).toBe(true);
    await putBack(app, memories);
  }
});
