import { act, fireEvent, screen, within } from '@testing-library/preact';
import { expect, it } from 'vitest';
import { messages } from '../../../src/app/messages/index.js';
import { en } from '../../tools/en.js';
import { idle, run } from '../bench/bench.js';
import { drawn, press, type } from '../screen.js';
import { BACKUP, lancerConnected, savedAs, WIND } from '../two-models.js';

const { save: words } = en.library;

it('the button names what it overwrites, and the save is taken back', async () => {
  const bench = await drawn(await lancerConnected());
  await run(bench.session.opened.show(WIND));
  await idle(0);
  await type('DT time', '2:00');
  await press(words.over({ program: 'wind of Magpie' }));
  expect(savedAs(bench, 'wind')?.program.times[10]).toBe(12_000);
  await press(words.undo({ name: 'wind' }));
  expect(savedAs(bench, 'wind')).toEqual(WIND);
  act(() => bench.editor.revertAll());
  await idle(0);
  expect(screen.queryByRole('button', { name: /Magpie/ }), 'the values are the timer’s').toBeNull();
});

it('values of one model go under another only with a tick', async () => {
  const bench = await drawn(await lancerConnected());
  act(() => bench.session.onScreen.showBackup(BACKUP));
  await press(words.open);
  const dialog = within(screen.getByRole('dialog'));
  const model = dialog.getByRole<HTMLSelectElement>('combobox', { name: messages.value.label.model });
  const saves = () => dialog.getByRole<HTMLButtonElement>('button', { name: messages.value.save });
  expect(model.selectedOptions[0]?.textContent, 'the model of the backup, not of the timer').toBe('Magpie');
  fireEvent.input(dialog.getByRole('textbox', { name: words.name({ of: 'program' }) }), {
    target: { value: 'taken over' },
  });
  expect(saves().disabled).toBe(false);
  fireEvent.change(model, { target: { value: 'Lancer' } });
  await idle(0);
  expect(saves().disabled).toBe(true);
  fireEvent.click(dialog.getByRole('checkbox', { name: words.crossing({ from: 'Magpie', to: 'Lancer' }) }));
  await idle(0);
  fireEvent.click(saves());
  await idle();
  const made = bench.session.library.settings.list.value.find(({ setting }) => setting.name === 'taken over');
  expect(made?.setting.model).toBe('Lancer');
});

it('a name that its model has already is saved over with a tick, or changed', async () => {
  const bench = await drawn(await lancerConnected());
  await run(bench.session.opened.show(WIND));
  await idle(0);
  await type('DT time', '2:00');
  await press(words.asNew);
  const dialog = within(screen.getByRole('dialog'));
  const saves = () => dialog.getByRole<HTMLButtonElement>('button', { name: messages.value.save });
  const tick = () => dialog.queryByRole<HTMLInputElement>('checkbox', { name: words.replace });
  const named = async (name: string): Promise<void> => {
    fireEvent.input(dialog.getByRole('textbox', { name: words.name({ of: 'program' }) }), { target: { value: name } });
    await idle(0);
  };
  expect(dialog.getByText(words.taken({ program: 'wind of Magpie' }))).toBeTruthy();
  expect(saves().disabled).toBe(true);
  await named('gusts');
  expect([tick(), saves().disabled]).toEqual([null, false]);
  await named(' wind ');
  expect(saves().disabled).toBe(true);
  fireEvent.click(tick() as HTMLInputElement);
  await idle(0);
  fireEvent.click(saves());
  await idle();
  const ofName = bench.session.library.settings.list.value.filter(({ setting }) => setting.name === 'wind');
  expect(ofName).toMatchObject([
    { key: WIND.id, setting: { note: WIND.note, tags: WIND.tags }, versions: [{ program: WIND.program }] },
  ]);
  expect(ofName[0]?.setting.program.times[10]).toBe(12_000);
  await press(words.undo({ name: 'wind' }));
  expect(savedAs(bench, 'wind')).toEqual(WIND);
});
