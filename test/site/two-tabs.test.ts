import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { type AppOptions, AppPage } from './app-page.js';

const { takeOver } = en.otherTab;
const timers: Readonly<Record<string, { options?: AppOptions; reach: (app: AppPage) => Promise<void> }>> = {
  simulated: { reach: (app) => app.trySimulated('F1Q') },
  real: { options: { bench: { granted: true } }, reach: (app) => app.connect() },
};
const isOpen = new RegExp(`^${en.otherTab.holdsSince({ since: '\\d\\d:\\d\\d' })}`);

test.each(Object.entries(timers))(
  'one tab at a time works with a %s timer, and the work goes along to the other one',
  async (_, timer) => {
    const first = await AppPage.open(timer.options);
    await timer.reach(first);
    await first.type('Function 2, S1', '7');
    const second = await first.waitingTab();
    await second.page.getByRole('heading', { name: isOpen }).waitFor();
    expect(await second.page.getByRole('button').allInnerTexts(), 'all that it can do').toEqual([takeOver]);
    for (const [from, to] of [
      [first, second],
      [second, first],
    ] as const) {
      await to.button(takeOver).click();
      await to.says(en.notes.back.title);
      await expect.poll(() => to.valueOf('Function 2, S1')).toBe('7');
      await from.page.getByRole('heading', { name: isOpen }).waitFor();
      expect(await from.table.count()).toBe(0);
    }
    await first.page.close();
    await second.says(en.notes.back.title);
  },
);

test('a tab that is asked for in the middle of a write first ends it', async () => {
  const first = await AppPage.connected({ bench: { timing: true } });
  await first.type('DT time', '4:00');
  await first.type('Function 2, S1', '7');
  const second = await first.waitingTab();
  await second.button(takeOver).waitFor();
  await first.write();
  await first.dialog.getByRole('button', { name: 'Stop' }).waitFor();
  await second.button(takeOver).click();
  await second.text(en.otherTab.busy).waitFor();
  expect(await second.page.getByRole('button').allInnerTexts()).toEqual([takeOver]);
  await second.page.getByRole('heading', { name: en.start.title }).waitFor();
  expect(await first.bench(({ content }) => [content.times[10], content.positions[0]?.[2]])).toEqual([24_000, 7]);
  expect(await second.stored('unfinished'), 'nothing is left of the write but what the timer holds').toEqual([]);
  expect(await second.page.getByRole('region', { name: 'Not certain' }).count()).toBe(0);
});
