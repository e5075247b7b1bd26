import { act, screen } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { VIEWS } from '../../../src/app/shell/views.js';
import { withValue } from '../../../src/program/index.js';
import { en } from '../../tools/en.js';
import { type AppBench, idle, run } from '../bench/bench.js';
import { button, connected, fly, goTo, loadedAgain, lookAt, press, strandAtM3, type } from '../screen.js';

const { recovery, bench: words } = en;
const OTHER = 'the F1Q 536';

function band(): string | null {
  return document.querySelector('.top .unfinished')?.textContent?.replaceAll('\u00a0', ' ') ?? null;
}

/** The cable is pulled as soon as the timer has made M3 current. */
function cutAtM3({ timer, adapter }: AppBench): void {
  timer.core.onAnswer = ({ name }) => {
    if (name === 'SETMEMORY' && timer.core.memory === 2) adapter.unplug();
  };
}

const CUT: readonly [job: string, said: string, start: (app: AppBench) => Promise<void>][] = [
  [
    'a look',
    recovery.mayFly({ memory: `M3 of ${OTHER}` }),
    async () => {
      await lookAt('M3');
      await press('Edit M3');
    },
  ],
  [
    'reading all memories',
    recovery.mayNotFly({ original: `M1 of ${OTHER}` }),
    async () => {
      await press(en.overview.readAll);
    },
  ],
  ['a copy', recovery.mayNotFly({ original: `M1 of ${OTHER}` }), () => press('Copy M1 to M3')],
  [
    'a restore',
    recovery.mayNotFly({ original: `M1 of ${OTHER}` }),
    async ({ write, editor }) => {
      const program = { ...(editor.baseline.value as NonNullable<typeof editor.baseline.value>), memory: 2 };
      const backup = { key: '1', savedAt: 1, reason: 'write', program, simulated: false } as const;
      void write.open({ kind: 'restore', backups: [backup] });
      await idle();
    },
  ],
];

describe('a job that was cut while another memory was current', () => {
  it.each(CUT)(
    'is said after %s, in every view, without a timer, until a reading settles it',
    async (_, said, start) => {
      const app = await connected();
      cutAtM3(app);
      await start(app);
      expect(app.timer.core.memory).toBe(2);
      app.write.dismiss();
      await act(() => run(app.session.timer.disconnect()));
      await idle();
      expect(band(), 'after Disconnect').toContain(said);
      const after = await loadedAgain(app);
      expect(screen.getByRole('heading', { name: en.start.title }), 'the start').toBeTruthy();
      for (const view of [...VIEWS, 'help', 'print'] as const) {
        await goTo(view);
        expect(band(), view).toContain(said);
      }
      await goTo('program');
      await press(en.knowledge.connect);
      expect(screen.getByRole('region', { name: en.timer['memory-left'].title }).textContent).toContain(
        'Now M3 flies next.',
      );
      await press(en.look.fly({ memory: 'M1' }));
      expect([band(), after.timer.core.memory, after.store.unfinished.records.size]).toEqual([null, 0, 0]);
    },
  );

  it('is settled by a reading that finds the memory from before', async () => {
    const app = await connected();
    cutAtM3(app);
    await lookAt('M3');
    await press('Edit M3');
    app.timer.core.memory = 0;
    await loadedAgain(app);
    await press(en.knowledge.connect);
    expect(band()).toBeNull();
  });

  it.each([
    ['after the timer took it', 'M3', (app: AppBench) => cutAtM3(app)],
    [
      'before the timer took it',
      'M1',
      ({ timer: { core }, adapter }: AppBench) => {
        core.onAnswer = ({ name }) => name === 'GETSWVER' && core.memory === 0 && adapter.unplug();
      },
    ],
  ])('is said after making M3 fly next, cut %s, until a reading shows that %s flies', async (_, flies, cut) => {
    const app = await connected();
    await lookAt('M3');
    cut(app);
    await press(en.look.fly({ memory: 'M3' }));
    await act(() => run(app.session.timer.disconnect()));
    await idle();
    expect(band(), 'after Disconnect').toContain(recovery.mayFly({ memory: `M3 of ${OTHER}` }));
    const after = await loadedAgain(app);
    expect(band(), 'after a reload').toContain(recovery.mayFly({ memory: `M3 of ${OTHER}` }));
    await press(en.knowledge.connect);
    expect([band(), after.store.unfinished.records.size]).toEqual([null, 0]);
    expect(screen.getByRole('radio', { name: en.nextFlight.named({ memory: flies }), checked: true })).toBeTruthy();
  });

  it('is not said after a memory that was made to fly next', async () => {
    const app = await connected();
    await fly('M3');
    expect([band(), app.store.unfinished.records.size]).toEqual([null, 0]);
  });

  it('is settled by the pilot, who makes a memory fly next or forgets it', async () => {
    const app = await connected();
    await strandAtM3(app);
    expect(band()).toContain(en.timer['memory-left'].title);
    await fly('M2');
    expect([band(), app.store.unfinished.records.size]).toEqual([null, 0]);
    cutAtM3(app);
    await lookAt('M3');
    await press(en.look.edit({ memory: 'M3' }));
    await loadedAgain(app);
    await press(en.knowledge.forget);
    await press(en.knowledge.forgetNow);
    expect(band()).toBeNull();
  });

  it('is not said while it runs', async () => {
    const app = await connected();
    const seen: (string | null)[] = [];
    app.timer.core.onAnswer = ({ name }) => name === 'GETTIMERS' && void seen.push(band());
    await lookAt('M3');
    await press('Edit M3');
    expect([...new Set(seen)]).toEqual([null]);
    expect(app.store.unfinished.records.size).toBe(0);
  });

  it('is what the checklist says in place of “No timer has been read”', async () => {
    const app = await connected();
    cutAtM3(app);
    await lookAt('M3');
    await press('Edit M3');
    await loadedAgain(app);
    await goTo('help');
    expect(document.querySelector('.known-now')?.textContent).toBe(recovery.mayFly({ memory: `M3 of ${OTHER}` }));
  });
});

it('tried positions are asked about in every view and after a reload, until they are kept or put back', async () => {
  const app = await connected();
  app.session.safety.confirm();
  await run(app.bench.moveTo(4));
  await run(app.follow.start());
  await type('Function 4, S2', '70');
  expect(band(), 'not while the servos follow').toBeNull();
  await run(app.follow.stop());
  await idle();
  expect(band()).toContain('Tried: Function 4, S2: 55 → 70.');
  const after = await loadedAgain(app);
  for (const view of VIEWS) {
    await goTo(view);
    expect(band(), view).toContain(words.triedIn({ memory: `M1 of ${OTHER}` }));
    expect(band(), view).toContain(words.decide);
  }
  await goTo('program');
  await press(en.knowledge.connect);
  expect(band()).toContain('Tried: Function 4, S2: 55 → 70.');
  await press(words.putBack);
  expect(after.editor.changes.value).toMatchObject([{ from: 70, to: 55 }]);
  act(() => after.write.dismiss());
  await press(words.keep);
  expect(band()).toBeNull();
  await loadedAgain(after);
  expect(band()).toBeNull();
});

describe('a connection that ends while the servos follow', () => {
  /** Function 4, S2 was tried, and no reading has shown it yet. */
  async function tried(): Promise<AppBench> {
    const app = await connected();
    app.session.safety.confirm();
    await run(app.bench.moveTo(4));
    await run(app.follow.start());
    await type('Function 4, S2', '70');
    await type('Function 4, S2', '71');
    return app;
  }

  it('because the pilot disconnects: it ends first, with a reading, and nothing was interrupted', async () => {
    const app = await tried();
    await press(en.header.disconnect);
    expect(app.session.link.state.value.status).toBe('off');
    expect([app.follow.on.value, app.session.knowledge.uncertain.value]).toEqual([false, []]);
    expect(band()).toContain(words.triedIn({ memory: `M1 of ${OTHER}` }));
    await press(en.knowledge.connect);
    expect(app.session.notices.current.value).toBeNull();
    expect(band()).toContain('Tried: Function 4, S2: 55 → 71.');
  });

  it.each([true, false])('because the plug is pulled: no write was interrupted, stored or not: %s', async (stored) => {
    const app = await tried();
    app.timer.core.onAnswer = ({ name }) => name === 'SETSERVO' && app.adapter.unplug();
    await type('Function 4, S2', '72');
    app.timer.core.onAnswer = undefined;
    if (!stored) (app.timer.core.content.positions[1] as number[])[4] = 71;
    expect(band()).toContain(`M1 of ${OTHER} holds: function 4, S2 is 71 or 72.`);
    expect(band()).not.toContain('interrupted');
    app.adapter.replug();
    await idle();
    expect([app.session.notices.current.value, app.session.recovery.offer.value]).toEqual([null, null]);
    expect(band()).toContain(`Tried: Function 4, S2: 55 → ${stored ? 72 : 71}.`);
  });

  it('and where another timer is there then, asks whether it is one', async () => {
    const app = await tried();
    app.timer.core.onAnswer = ({ name }) => name === 'SETSERVO' && app.adapter.unplug();
    await type('Function 4, S2', '72');
    app.timer.core.onAnswer = undefined;
    (app.timer.core.content.positions[1] as number[])[4] = 9;
    app.adapter.replug();
    await idle();
    expect(document.body.textContent).toContain(
      `${words.triedIn({ memory: 'M1' })} 1 value in the timer is neither old`,
    );
    expect(document.body.textContent).not.toContain('interrupted');
  });
});

describe('several unfinished jobs', () => {
  it('are one band, the worst first, the rest behind it', async () => {
    const app = await connected();
    const before = app.editor.baseline.value as NonNullable<typeof app.editor.baseline.value>;
    await strandAtM3(app);
    await app.session.knowledge.begin(before, withValue(before, { kind: 'time', slot: 10 }, 36_000));
    app.session.knowledge.jobOver();
    await idle(0);
    expect(document.querySelectorAll('.unfinished > section')).toHaveLength(1);
    expect(band()).toContain('It is not known what M1 holds: DT is 3:00 min or 6:00 min.');
    expect(band()).not.toContain(en.timer['memory-left'].title);
    await press(en.more({ count: 1 }));
    expect(band()).toContain(en.timer['memory-left'].title);
    expect(button(en.more({ count: 1 })).getAttribute('aria-expanded')).toBe('true');
  });

  it('an interrupted write is in sight above every view after a replug', async () => {
    const app = await connected();
    await type('DT time', '4:00');
    await type('Function 2, S1', '7');
    await press('Write…');
    app.session.safety.confirm();
    await idle(0);
    app.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && app.adapter.unplug();
    await press('Write 2 changes');
    app.timer.core.onAnswer = undefined;
    await press('Close');
    await goTo('library');
    app.adapter.replug();
    await idle();
    expect(band()).toContain(recovery.title);
    expect([button(recovery.finish).disabled, button(recovery.goBack).disabled]).toEqual([false, false]);
  });
});
