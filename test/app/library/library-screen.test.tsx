import { fireEvent, screen, within } from '@testing-library/preact';
import { expect, it, vi } from 'vitest';
import { dateText, messages } from '../../../src/app/messages/index.js';
import { SHAPES } from '../../../src/app/ui/shapes.js';
import type { Setting } from '../../../src/program/index.js';
import { en } from '../../tools/en.js';
import { type AppBench, idle, run } from '../bench/bench.js';
import { button, goTo, inWindow, opened, press, type } from '../screen.js';
import { stored } from './stored.js';

/** The page with a small library, at a place in it. */
async function at(path: string) {
  const app = await opened({ store: stored({ models: 2, settings: 4, flights: 0 }) });
  app.models.views.show('library', path);
  await idle();
  return app;
}

function input(name: string): HTMLInputElement {
  return screen.getByRole<HTMLInputElement>('textbox', { name });
}

async function write(name: string, text: string): Promise<void> {
  fireEvent.input(input(name), { target: { value: text } });
  await idle(0);
}

it('is empty at first, and says what a model is for and how to begin', async () => {
  await opened();
  await goTo('library');
  await idle();
  screen.getByText(en.library.empty.title);
  screen.getByText(en.library.empty.hint);
  expect(screen.getByRole('button', { name: 'New model…' })).toBeTruthy();
  expect(screen.queryByRole('link', { name: /setting/ })).toBeNull();
});

it.each(['', 'model-0', 'model-0/setting-0'])(
  'that the browser does not give out is never called empty or gone, at “%s”, and comes when it is asked for again',
  async (path) => {
    const store = stored({ models: 2, settings: 4, flights: 0 });
    const all = [store.models.all, store.settings.all] as const;
    const refuse = () => Promise.reject(new DOMException('held by an old tab', 'UnknownError'));
    store.models.all = refuse;
    store.settings.all = refuse;
    const app = await opened({ store });
    app.models.views.show('library', path);
    await idle();
    screen.getByText(en.library.unread);
    expect(screen.queryByText(/No model yet|A model holds|not in the library any more/)).toBeNull();
    [store.models.all, store.settings.all] = all;
    await press('Try again');
    expect(screen.queryByText(en.library.unread)).toBeNull();
    expect(screen.getAllByText(/Lancer 01|fly-off 0/).length).toBeGreaterThan(0);
  },
);

it('opens without the flights, and reads each list once, however often it is opened', async () => {
  const store = stored({ models: 2, settings: 4, flights: 0 });
  const reads = (['models', 'settings', 'flights'] as const).map((shelf) => vi.spyOn(store[shelf], 'all'));
  await opened({ store });
  for (const view of ['library', 'program', 'library'] as const) await goTo(view);
  expect(screen.getAllByRole('link', { name: /Lancer 01/ }).length).toBeGreaterThan(0);
  expect(reads.map((read) => read.mock.calls.length)).toEqual([1, 1, 0]);
});

it.each<[when: string, act: (app: AppBench) => void]>([
  ['when the pilot leaves its field', () => fireEvent.blur(input('Note'))],
  ['when the pilot leaves its page', ({ models }) => models.views.show('program')],
  ['a moment after the last key', () => {}],
])('a note is kept %s', async (_, act) => {
  const app = await at('model-0/setting-0');
  await write('Note', 'opens well');
  expect(app.store.settings.records.get('setting-0')?.setting.note).not.toBe('opens well');
  act(app);
  await idle();
  expect(app.store.settings.records.get('setting-0')?.setting.note).toBe('opens well');
});

it('a name cannot become empty', async () => {
  const app = await at('model-0/setting-0');
  const before = input('Name').value;
  await write('Name', '  ');
  expect(screen.getByText(en.library.nameNeeded)).toBeTruthy();
  fireEvent.blur(input('Name'));
  await idle();
  expect([input('Name').value, app.store.settings.records.get('setting-0')?.setting.name]).toEqual([before, before]);
});

it.each([
  ['Name', ' Lancer\u202e 07', 'Lancer 07'],
  [en.library.setting.tags, 'calm,windy,', 'calm, windy'],
])('what is typed into “%s” is shown as it is kept: %j', async (field, typed, kept) => {
  const app = await at('model-0/setting-0');
  await write(field, typed);
  expect(input(field).value).toBe(typed);
  fireEvent.blur(input(field));
  await idle();
  expect(input(field).value).toBe(kept);
  const { name, tags } = app.store.settings.records.get('setting-0')?.setting ?? {};
  expect(field === 'Name' ? name : tags?.join(', ')).toBe(kept);
});

it('the strip says which setting is open, and how many changes are not saved', async () => {
  await at('model-0/setting-0');
  await press(messages.value.open);
  expect(screen.getByText('Lancer 01, fly-off 0: saved')).toBeTruthy();
  await type('DT time', '2:00');
  expect(screen.getByText('Lancer 01, fly-off 0: 1 change not saved')).toBeTruthy();
  await press('Save over fly-off 0 of Lancer 01');
  // The storage answers a turn later than the timers that the press waits for.
  await idle(0);
  expect(screen.getByText('Lancer 01, fly-off 0: saved')).toBeTruthy();
});

it('a setting that is open can be loaded again after changes, as one step', async () => {
  const app = await at('model-0/setting-0');
  await press(messages.value.open);
  const { editor } = app.session;
  const saved = editor.working.value;
  const again = en.library.setting.loadAgain({ count: 3 });
  for (const slot of [1, 2, 3]) editor.type({ kind: 'position', servo: 0, slot }, '111');
  app.models.views.show('library', 'model-0/setting-0');
  await idle();
  expect(again).toBe('Open again: 3 values go back');
  await press(again);
  expect([editor.working.value, app.models.views.shown.value]).toEqual([saved, 'program']);
  editor.undo();
  expect(editor.working.value?.positions[0]?.slice(1, 4)).toEqual([111, 111, 111]);
});

it('a program is saved under a model that is made with it', async () => {
  const app = await at('model-0/setting-0');
  await press(messages.value.open);
  await press(en.library.save.asNew);
  const dialog = within(screen.getByRole('dialog'));
  const newModel = dialog.getByRole<HTMLOptionElement>('option', { name: en.library.models.make });
  fireEvent.change(dialog.getByRole('combobox', { name: 'Model' }), { target: { value: newModel.value } });
  await idle(0);
  fireEvent.input(dialog.getByRole('textbox', { name: 'Name of the program' }), { target: { value: ' calm ' } });
  fireEvent.input(dialog.getByRole('textbox', { name: 'Name of the model' }), { target: { value: 'Lancer 09' } });
  fireEvent.click(dialog.getByRole('button', { name: 'Save' }));
  await idle();
  const [model] = [...app.store.models.records.values()].filter(({ model: each }) => each.name === 'Lancer 09');
  const [made] = [...app.store.settings.records.values()].filter(({ setting }) => setting.name === 'calm');
  expect([model?.model.timerClass, made?.setting.model]).toEqual(['Q', model?.key]);
});

it('a setting that is deleted while its note is typed comes back to its place with undo', async () => {
  const app = await at('model-0/setting-0');
  const before = app.store.settings.records.get('setting-0');
  await write('Note', 'opens well');
  fireEvent.click(button('Delete'));
  await idle(2000);
  expect(app.session.library.settings.get('setting-0')).toBeUndefined();
  app.session.library.undoRemove();
  await idle();
  const { list } = app.session.library.settings;
  expect([list.value.at(-1), app.store.settings.records.get('setting-0')]).toEqual([before, before]);
});

it('a phone saves a program from what the strip opens', async () => {
  inWindow((query) => query.includes(SHAPES.phone));
  await at('model-0/setting-0');
  await press(messages.value.open);
  expect(
    screen.queryByRole('button', { name: en.library.save.asNew }),
    'the bar of a phone has no room for this button',
  ).toBeNull();
  fireEvent.click(document.querySelector('.strip-more') as HTMLElement);
  await idle();
  expect(screen.getByRole('button', { name: en.library.save.asNew })).toBeTruthy();
});

it('the earlier versions of a program say until when and what was changed, are compared and come back', async () => {
  const app = await at('model-0/setting-0');
  const { settings } = app.session.library;
  expect(screen.queryByText(en.versions.title)).toBeNull();
  const setting = settings.get('setting-0')?.setting as Setting;
  const { program } = setting;
  const changed = { ...program, times: program.times.with(10, 21_000), idleThrottle: 25 };
  await run(app.session.library.keepSetting({ ...setting, program: changed }));
  await idle(0);
  const rows = () =>
    [...(screen.getByText(en.versions.title).parentElement?.querySelectorAll('li') ?? [])].map((row) =>
      row.textContent?.replaceAll('\u00a0', ' '),
    );
  const [until = 0] = settings.get('setting-0')?.versions?.map((each) => each.until) ?? [];
  const name = en.versions.until({ when: dateText(until) });
  expect(rows()).toEqual([
    `${name.replaceAll('\u00a0', ' ')} then DT: 3:00 min → 3:30 min and 1 moreCompare…${en.versions.goBack}`,
  ]);
  await press(messages.value.of({ button: en.compare.open, name }));
  const chosen = screen.getAllByRole<HTMLSelectElement>('combobox').map((each) => each.selectedOptions[0]?.textContent);
  expect(chosen).toEqual([`fly-off 0 · ${name}`, 'Lancer 01 · fly-off 0']);
  app.models.views.show('library', 'model-0/setting-0');
  await idle(0);
  await press(messages.value.of({ button: en.versions.goBack, name }));
  expect(settings.get('setting-0')?.setting).toEqual(setting);
  expect(rows()).toHaveLength(2);
  expect(rows()[1], 'it is what the setting holds').toContain(en.versions.same);
});
