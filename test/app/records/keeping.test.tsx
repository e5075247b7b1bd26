import { readFileSync } from 'node:fs';
import { act, render, screen, within } from '@testing-library/preact';
import { describe, expect, it, vi } from 'vitest';
import { App } from '../../../src/app/app.js';
import { countedText } from '../../../src/app/messages/names.js';
import type { Backup } from '../../../src/app/storage/index.js';
import { Drafts } from '../../../src/app/work/drafts.js';
import type { TimerProgram } from '../../../src/program/index.js';
import { MODEL } from '../../program/library-examples.js';
import { en } from '../../tools/en.js';
import { type AppBench, appBench, connectedBench, idle, MemoryStore, run } from '../bench/bench.js';
import { FAULTS, FaultyStore } from '../faults.js';
import { programOf } from '../programs.js';
import { press } from '../screen.js';

function kept(store: MemoryStore, ...keys: string[]): void {
  for (const [i, key] of keys.entries()) {
    const program = { ...programOf('Q', [0, 1, 2, 3]), memory: i };
    const backup: Backup = { key, savedAt: 5, reason: 'memories', program, simulated: false };
    store.backups.records.set(key, backup);
  }
}
const stored = ({ store }: AppBench): string[] => [...store.backups.records.keys()];
const listed = ({ session }: AppBench): string[] => session.backups.list.value.map(({ key }) => key);

describe('a backup that is deleted', () => {
  async function shown(): Promise<AppBench> {
    const store = new MemoryStore();
    kept(store, 'a', 'b', 'c');
    const bench = await appBench({ store });
    render(<App models={bench.models} />);
    return bench;
  }
  const said = (count: number) =>
    screen.queryByText(en.removed({ what: countedText({ backups: count }) }), { normalizer: (text) => text });

  it('can be put back for ten seconds after the last one, a set of several as one', async () => {
    const bench = await shown();
    bench.session.backups.remove('a');
    await idle(9000);
    bench.session.backups.remove('b');
    await idle(9999);
    expect([listed(bench), stored(bench)]).toEqual([['c'], ['a', 'b', 'c']]);
    expect(said(2)).toBeTruthy();
    await press(en.undo);
    await idle();
    expect(listed(bench)).toEqual(['c', 'b', 'a']);
    expect([stored(bench), said(2)]).toEqual([['a', 'b', 'c'], null]);
  });

  it('is offered before all else, and a calm notice does not hide that nothing is kept', async () => {
    const bench = await shown();
    const style = document.head.appendChild(document.createElement('style'));
    style.textContent = readFileSync(`${import.meta.dirname}/../../../src/app/ui/shared.css`, 'utf8');
    const seen = () =>
      [...document.querySelectorAll('.notices > *')].filter((each) => getComputedStyle(each).display !== 'none');
    bench.session.notices.say('backed-up');
    bench.keeping.heard('models', 'change', false);
    bench.session.backups.remove('a');
    await idle(0);
    const wanted = [en.undo, en.keeping.title].map((text) => expect.stringContaining(text));
    expect(seen().map(({ textContent }) => textContent)).toEqual(wanted);
    style.remove();
  });

  it.each(['after that', 'when the page is left'])('is gone %s', async (when) => {
    const bench = await shown();
    bench.session.backups.remove('a');
    if (when === 'after that') await idle(10_000);
    else bench.session.backups.flush();
    await idle(0);
    expect([stored(bench), said(1)]).toEqual([['b', 'c'], null]);
    bench.session.backups.undoRemove();
    expect(listed(bench)).toEqual(['c', 'b']);
  });

  it('does not come back when the list is read again', async () => {
    const bench = await shown();
    bench.session.backups.remove('a');
    await run(bench.session.keptWork.bringBack());
    expect(listed(bench)).toEqual(['c', 'b']);
  });
});

it('when the storage works again, all is read at most once a second while one call fails', async () => {
  const store = new FaultyStore();
  store.fail('drafts.all', 'refuses');
  const bench = await connectedBench({ store });
  bench.editor.type({ kind: 'position', servo: 0, slot: 2 }, '7');
  await idle(1000);
  const looks = vi.spyOn(bench.session.backups, 'load');
  void bench.session.keptWork.bringBack();
  await idle(10_000);
  expect(looks.mock.calls.length).toBeGreaterThan(0);
  expect(looks.mock.calls.length).toBeLessThanOrEqual(11);
});

it('a backup and the note of a write that found no room are kept once there is room and the pilot comes back', async () => {
  const store = new FaultyStore();
  const { session, keeping } = await connectedBench({ store });
  const { editor, backups, knowledge } = session;
  const before = editor.working.value as TimerProgram;
  store.before = (door) => (door.endsWith('.save') ? FAULTS['is full']() : undefined);
  const added = backups.add(before, 'write', false);
  const begun = knowledge.begin(before, { ...before, idleThrottle: 7 });
  await idle();
  expect([await added, await begun, keeping.kept.value]).toEqual([false, false, false]);
  keeping.tryAgain();
  keeping.dismiss();
  await idle();
  expect([keeping.kept.value, keeping.dismissed.value]).toEqual([false, true]);
  store.before = () => undefined;
  keeping.tryAgain();
  await idle();
  expect([...store.backups.records.values()]).toEqual(backups.list.value);
  expect([...store.unfinished.records.values()]).toMatchObject([{ kind: 'write', goal: { idleThrottle: 7 } }]);
  expect(keeping.kept.value).toBe(true);
  keeping.heard('models', 'change', false);
  expect(keeping.dismissed.value, 'what fails once more is said once more').toBe(false);
  keeping.heard('models', 'change', true);
  keeping.lack('tabs');
  keeping.dismiss();
  for (const kept of [false, true]) keeping.heard('models', 'change', kept);
  expect(keeping.dismissed.value, 'what was read meanwhile is not said again').toBe(true);
});

it('work that could not be read is not lost when other work comes to its place and goes again', async () => {
  const { editor, store } = await connectedBench();
  editor.type({ kind: 'position', servo: 0, slot: 2 }, '7');
  await idle();
  const [unseen] = store.drafts.records.values();
  if (!unseen) throw new Error('it is gone');
  const drafts = new Drafts(store.drafts);
  store.broken = true;
  const { baseline } = unseen;
  drafts.keep(
    { baseline, working: { ...baseline, times: baseline.times.map((time) => time + 100) }, texts: {} },
    false,
  );
  drafts.keep({ baseline, working: baseline, texts: {} }, false);
  await idle();
  store.broken = false;
  await run(drafts.keepAgain());
  expect([...store.drafts.records.values()]).toMatchObject([{ working: unseen.working }]);
  expect(drafts.edited.value).toMatchObject([{ working: unseen.working }]);
});

it('a program that the pilot has closed stays closed while the storage is tried again', async () => {
  const store = new FaultyStore();
  const { session, editor, keeping } = await connectedBench({ store });
  editor.type({ kind: 'position', servo: 0, slot: 2 }, '7');
  await run(session.timer.disconnect());
  await idle();
  session.onScreen.closeProgram();
  store.fail('change', 'is full');
  void session.library.keepModel(MODEL).catch(() => {});
  await idle(1000);
  expect([keeping.kept.value, editor.working.value]).toEqual([false, null]);
  keeping.tryAgain();
  await idle();
  expect(editor.working.value).toBeNull();
});

describe('an unreadable record', () => {
  async function found(shelf: string): Promise<AppBench> {
    const store = new MemoryStore();
    store.aside.records.set('a', { key: 'a', shelf, at: 5, stored: { key: 'x', time: Number.NaN } });
    const bench = await appBench({ store });
    render(<App models={bench.models} />);
    return bench;
  }

  it('is reported, can be saved, and is not reported again', async () => {
    const bench = await found('drafts');
    expect(screen.getByText(en.aside.title({ count: 1 }))).toBeTruthy();
    expect(screen.queryByText(/read the timer before you fly/)).toBeNull();
    expect(JSON.parse(bench.models.aside.asText())).toMatchObject([{ stored: { key: 'x', time: 'NaN' } }]);
    expect(screen.getByRole('button', { name: en.aside.save })).toBeTruthy();
    await press('Dismiss');
    expect(screen.queryByText(/could not be read/)).toBeNull();
    const next = await appBench({ store: bench.store });
    expect([next.models.aside.isNew.value, next.models.aside.list.value.length]).toEqual([false, 1]);
  });

  it('is reported also when the clock was ahead as the one before it was set aside', async () => {
    const { models, store } = await found('drafts');
    models.aside.dismiss();
    store.aside.records.set('b', { key: 'b', shelf: 'models', at: 4, stored: { key: 'y' } });
    const next = await appBench({ store });
    expect(next.models.aside.isNew.value).toBe(true);
    next.models.aside.dismiss();
    expect((await appBench({ store })).models.aside.isNew.value).toBe(false);
  });

  it.each(['models', 'settings', 'flights'] as const)(
    'is reported when the %s are read, however late',
    async (shelf) => {
      const store = new MemoryStore();
      let read = (): void => {};
      const asked = new Promise<void>((resolve) => (read = resolve));
      vi.spyOn(store[shelf], 'all').mockImplementation(async () => {
        await asked;
        store.aside.records.set('a', { key: 'a', shelf, at: 5, stored: { key: 'x' } });
        return [];
      });
      const { models, session } = await appBench({ store });
      const reading = session.library[shelf].load();
      await idle(0);
      expect(models.aside.isNew.value).toBe(false);
      read();
      await run(reading);
      await idle(0);
      expect(models.aside.isNew.value).toBe(true);
    },
  );

  it('is named when it may be the note of a write', async () => {
    await found('unfinished');
    expect(screen.getByText(/read the timer before you fly/)).toBeTruthy();
  });
});

describe('everything on this device', () => {
  const dialog = () => within(screen.getByRole('dialog', { name: /^Delete everything/ }));
  const ask = async ({ models }: AppBench): Promise<void> => {
    render(<App models={models} />);
    act(() => models.views.show('settings'));
    await press(en.erase.open);
  };

  it('waits for a job, so that no note of a write goes before its end was seen', async () => {
    const reload = vi.fn();
    const bench = await connectedBench({ reload });
    let end = (): void => {};
    const job = bench.session.runner.run('write', () => new Promise<void>((resolve) => (end = resolve)));
    bench.erase.open();
    const erasing = bench.erase.start();
    await idle();
    expect([bench.session.runner.job.value?.stopping, reload.mock.calls.length]).toEqual([false, 0]);
    end();
    await run(Promise.all([job, erasing]));
    expect(reload).toHaveBeenCalledOnce();
  });

  it('is deleted after a question, once, and the page begins afresh', async () => {
    const reload = vi.fn();
    const done: string[] = [];
    const eraser = (name: string) => async () => void done.push(name);
    const erasers = { settings: eraser('settings'), ports: eraser('ports'), offline: eraser('offline') };
    const bench = await connectedBench({ reload, erasers });
    await ask(bench);
    expect(dialog().queryByRole('alert')).toBeNull();
    expect([bench.store.ports.records.size, done, reload.mock.calls.length], 'before the answer').toEqual([1, [], 0]);
    await press(en.erase.start);
    await idle();
    expect([bench.store.ports.records.size, done]).toEqual([0, ['settings', 'ports', 'offline']]);
    expect([reload.mock.calls.length, bench.session.link.state.value.status]).toEqual([1, 'off']);
  });

  it('warns when it is not known what a timer holds', async () => {
    const bench = await connectedBench();
    const { baseline } = bench.editor;
    if (!baseline.value) throw new Error('nothing was read');
    const times = baseline.value.times.map(() => 0);
    await bench.session.knowledge.begin(baseline.value, { ...baseline.value, times });
    bench.session.knowledge.jobOver();
    await run(bench.session.timer.disconnect());
    await ask(bench);
    expect(dialog().getByRole('alert').textContent).toBe(en.erase.uncertain);
  });

  it('stays, with the page, when a part of it could not be deleted, and that is said', async () => {
    const reload = vi.fn();
    const [fine, fails] = [async () => {}, () => Promise.reject(new Error('no'))];
    const erasers = { settings: fine, ports: () => new Promise<void>(() => {}), offline: fails };
    const bench = await appBench({ reload, erasers });
    bench.store.broken = true;
    await ask(bench);
    await press(en.erase.start);
    await idle();
    expect(dialog().getByRole('alert').textContent).toBe(en.erase.failed);
    expect(reload).not.toHaveBeenCalled();
  });
});
