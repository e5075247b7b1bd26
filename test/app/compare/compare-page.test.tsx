import { fireEvent, screen, within } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { whole } from '../../../src/app/messages/dotted.js';
import { messages } from '../../../src/app/messages/index.js';
import type { ModelRecord, SettingRecord } from '../../../src/app/storage/index.js';
import type { TimerProgram } from '../../../src/program/index.js';
import { exampleMemories } from '../../../src/simulator/index.js';
import { MODEL, SETTING } from '../../program/library-examples.js';
import { en } from '../../tools/en.js';
import { type AppBench, appBench, idle, MemoryStore, run } from '../bench/bench.js';
import { button, drawn, press } from '../screen.js';

const IDENTITY = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };
const [CALM, WIND] = exampleMemories('Q').map(
  ({ times, positions }): TimerProgram => ({ identity: IDENTITY, memory: 0, times, positions, idleThrottle: 30 }),
) as [TimerProgram, TimerProgram];
/** Three values of the calm one. */
const TRIMMED: TimerProgram = {
  ...CALM,
  times: CALM.times.with(10, 24_000),
  positions: CALM.positions.map((row, servo) => (servo === 1 ? row.with(4, 77).with(5, 33) : row)),
};

function setting(name: string, program: TimerProgram): SettingRecord {
  return { key: name, changedAt: 1, setting: { ...SETTING, id: name, name, model: 'lancer', program } };
}

const LANCER: ModelRecord = {
  key: 'lancer',
  changedAt: 1,
  verified: [{ program: CALM, at: 1_795_000_000_000 }],
  model: { ...MODEL, id: 'lancer', name: 'Lancer', memoryNames: [] },
};

/** The page with these settings, and a timer that holds the calm one where it is connected. */
async function page(connect: boolean, ...settings: readonly SettingRecord[]): Promise<AppBench> {
  const store = new MemoryStore();
  store.models.records.set('lancer', LANCER);
  for (const record of settings) store.settings.records.set(record.key, record);
  const bench = await appBench({ store, identity: IDENTITY });
  const { core } = bench.timer;
  core.memories.splice(0, 1, { times: [...CALM.times], positions: CALM.positions.map((row) => [...row]) });
  await drawn(bench);
  await bench.session.library.load();
  if (connect) await press('Connect');
  return bench;
}

async function compare(bench: AppBench, first: string | null, second: string | null = null): Promise<void> {
  bench.models.comparedPair.show(first, second);
  bench.models.views.show('library', 'compare');
  await idle(0);
}

const said = (): string | null => document.querySelector('.compare-values [role=status]')?.textContent ?? null;
const chosen = (name: string) =>
  screen.getByRole<HTMLSelectElement>('combobox', { name }).selectedOptions[0]?.textContent;
const options = (name: string) =>
  within(screen.getByRole('combobox', { name }))
    .getAllByRole('option')
    .map(({ textContent }) => textContent);

describe('two programs side by side', () => {
  it('are any two settings, without a timer: figures and timeline', async () => {
    const bench = await page(false, setting('calm', CALM), setting('trimmed', TRIMMED));
    await compare(bench, 'setting/calm', 'setting/trimmed');
    expect([chosen('Compare'), chosen('with')]).toEqual(['Lancer · calm', 'Lancer · trimmed']);
    expect(said()).toBe('3 values differ.');
    expect(screen.getAllByRole('row', { name: /Function 4, S2/ })).toHaveLength(1);
    expect(screen.getByLabelText(messages.value.timeline.title)).toBeTruthy();
    expect(screen.queryByRole('button', { name: /^Take/ })).toBeNull();
  });

  it('have the lane of the first servo that differs in front, until the pilot selects another one', async () => {
    const bench = await page(true, setting('trimmed', TRIMMED));
    await compare(bench, 'screen', 'setting/trimmed');
    const front = () =>
      [...document.querySelectorAll('.servo-line')].findIndex(({ classList }) => classList.contains('front'));
    expect(front()).toBe(1);
    fireEvent.keyDown(screen.getByRole('group', { name: en.timeline.picture }), { key: 'ArrowDown' });
    await press('Take 4:00 min for DT');
    expect(front(), 'other values change nothing').toBe(2);
  });

  it('are a setting and what the timer holds, or a backup', async () => {
    const bench = await page(true, setting('trimmed', TRIMMED));
    await bench.session.backups.add(WIND, 'write', false);
    await compare(bench, 'setting/trimmed');
    expect(options('with').slice(0, 2)).toEqual([en.compare.screen, 'Timer, M1']);
    expect(options('with').at(-1)).toMatch(/^Lancer · M1 · /);
    fireEvent.change(screen.getByRole('combobox', { name: 'with' }), { target: { value: 'timer/0' } });
    await idle(0);
    expect(said()).toBe('3 values differ.');
  });

  it('are only of one class and layout', async () => {
    const small = { ...SETTING.program, memory: null };
    const bench = await page(false, setting('calm', CALM), setting('small', small), setting('trimmed', TRIMMED));
    await compare(bench, 'setting/calm');
    expect(options('with')).toEqual(['Lancer · trimmed']);
    await compare(bench, 'setting/small');
    expect(document.querySelector('.compare-page')?.textContent).toContain(en.compare.nothing);
  });

  it('change to what is still there when one is deleted', async () => {
    const bench = await page(false, setting('calm', CALM), setting('trimmed', TRIMMED), setting('wind', WIND));
    await compare(bench, 'setting/calm', 'setting/trimmed');
    bench.session.library.settings.remove('trimmed');
    await idle(0);
    expect(chosen('with')).toBe('Lancer · wind');
  });
});

describe('values of the other program', () => {
  it('are taken one by one into the program on the screen, each as one step', async () => {
    const bench = await page(true, setting('trimmed', TRIMMED));
    await compare(bench, 'screen', 'setting/trimmed');
    await press('Take 77 for function 4, S2');
    expect(bench.editor.working.value?.positions[1]?.[4]).toBe(77);
    expect(said()).toBe('2 values differ.');
    await press('Take 4:00 min for DT');
    expect(bench.editor.changes.value).toHaveLength(2);
    bench.editor.undo();
    expect(bench.editor.undoStep.value).toMatchObject({ code: 'change', params: { field: 'position:1:4' } });
    expect(bench.editor.changes.value).toHaveLength(1);
  });

  it('stand under the name of their program, and the buttons beside them', async () => {
    const bench = await page(true, setting('trimmed', TRIMMED));
    await compare(bench, 'screen', 'setting/trimmed');
    const row = within(screen.getByRole('row', { name: /Function 4, S2/ }));
    expect(row.getAllByRole('cell').map(({ textContent }) => textContent)).toEqual(['52', '77', 'Take']);
  });

  it('are taken in the other order, too', async () => {
    const bench = await page(true, setting('trimmed', TRIMMED));
    await compare(bench, 'setting/trimmed', 'screen');
    await press('Take 77 for function 4, S2');
    expect(bench.editor.working.value?.positions[1]?.[4]).toBe(77);
  });

  it('stay where they are while the servos follow', async () => {
    const bench = await page(true, setting('trimmed', TRIMMED));
    await compare(bench, 'screen', 'setting/trimmed');
    expect(button('Take 77 for function 4, S2')).toBeTruthy();
    bench.session.safety.confirm();
    await run(bench.models.follow.start());
    await idle();
    if (!bench.models.follow.on.value) throw new Error('the servos do not follow');
    expect(screen.queryByRole('button', { name: /^Take/ })).toBeNull();
  });
});

describe('the backups of a model', () => {
  const { modelBackups } = en;

  it('stand on its page with what differs from now, and are loaded from there', async () => {
    const bench = await page(true);
    await bench.session.backups.add(TRIMMED, 'write', false);
    await bench.session.backups.add(CALM, 'write', false);
    bench.models.views.show('library', 'lancer');
    await idle(0);
    const rows = [...document.querySelectorAll('.kept-row')].map(({ textContent }) => textContent);
    expect(rows).toHaveLength(2);
    expect(rows[0]).toContain(whole(modelBackups.same({ when: modelBackups.now })));
    expect(rows[1]).toContain(modelBackups.differs({ count: 3, when: modelBackups.now }));
    fireEvent.click(screen.getAllByRole('button', { name: /^Open: M1/ })[1] as HTMLElement);
    await idle(0);
    expect([bench.models.views.shown.value, bench.editor.changes.value.length]).toEqual(['program', 3]);
  });

  it('say from when that is while the timer is not connected, and can be loaded without it', async () => {
    const bench = await page(false);
    const backup = { key: 'k', savedAt: Date.now(), reason: 'write', program: TRIMMED, simulated: false } as const;
    await bench.session.backups.save({ ...backup, model: 'lancer' });
    bench.models.views.show('library', 'lancer');
    await idle(0);
    expect(document.querySelector('.kept-row')?.textContent).toContain(modelBackups.differs({ count: 3, when: '' }));
    fireEvent.click(screen.getByRole('button', { name: /^Open: M1/ }));
    await idle(0);
    expect([bench.editor.madeAt.value === null, bench.editor.working.value?.times[10]]).toEqual([false, 24_000]);
  });
});
