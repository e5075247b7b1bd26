import { describe, expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { edited, held } from './edited.js';

describe('a write that the page did not survive', () => {
  /** The page is reloaded after the times and before the position is written. */
  async function interrupted(): Promise<AppPage> {
    const app = await edited();
    const asked: string[] = [];
    app.page.on('dialog', (dialog) => {
      asked.push(dialog.type());
      void dialog.accept();
    });
    await app.bench((bench) => bench.sleepAt('SETTIMERS'));
    await app.write();
    await expect.poll(() => held(app)).toEqual([24000, 35]);
    await app.reload();
    expect(asked).toEqual(['beforeunload']);
    await app.says(en.notes.back.title);
    return app;
  }
  const panel = (app: AppPage) => app.page.getByRole('region', { name: en.recovery.title });

  test('can be finished', async () => {
    const app = await interrupted();
    await app.button('Connect').click();
    await app.isReady();
    await panel(app).getByText('The timer holds 1 value of that write; 1 value is still as before.').waitFor();
    await panel(app).getByRole('button', { name: en.recovery.finish }).click();
    await app.dialog.waitFor();
    await expect.poll(() => app.difference()).toEqual(['Function 2, S1 | 35 | 7']);
    await app.tickSafety();
    await app.dialog.getByRole('button', { name: 'Write 1 change' }).click();
    await app.result('Verified.');
    expect(await held(app)).toEqual([24000, 7]);
    await app.close();
    await panel(app).waitFor({ state: 'detached' });
  });
});

test('all memories are backed up, one is copied to another, and the backup is restored', async () => {
  const app = await AppPage.connected();
  await app.bench(({ adapter }) => {
    const [first] = adapter.timer.core.memories;
    if (first) first.times[3] = 1234;
  });
  const memories = (): Promise<unknown[]> => app.bench(({ adapter }) => adapter.timer.core.memories);
  const before = await memories();
  const job = (name: string) => app.page.getByRole('dialog', { name });

  await app.goTo('Memories');
  await app.button(en.overview.readAll).click();
  await app.page.getByText(en.notes['backed-up'].title).waitFor();
  expect(await memories(), 'a backup changes no memory').toEqual(before);

  await app.page.getByLabel('Copy to…: M1', { exact: true }).click();
  await app.button('Copy M1 to M3').click();
  const copy = job('Copy M1 to M3');
  expect(await copy.getByRole('button', { name: /^Write/ }).isDisabled(), 'a copy can start only after the tick').toBe(
    true,
  );
  await copy.getByRole('checkbox', { name: 'The propeller is off' }).check();
  await copy.getByRole('button', { name: /^Write/ }).click();
  await copy.getByText(/^M3\sverified\s\d\d:\d\d\s· DT\s3:00\smin\s· motor\sstop\s10\.0\ss\s· 2\schanges$/).waitFor();
  await copy.getByText('M1 flies next.').waitFor();
  await app.button('Close').click();
  expect(await memories()).toEqual([before[0], before[1], before[0], before[3]]);
  expect(await app.bench(({ adapter }) => adapter.timer.core.memory), 'M1 is current again').toBe(0);

  await app.button('Restore all 4…').click();
  const restore = job(en.memories.restore);
  await restore.getByRole('button', { name: /^(Write|Read back)/ }).click();
  await restore.getByText(/^M4\sverified\s/).waitFor();
  await app.button('Close').click();
  expect(await memories()).toEqual(before);
  expect(await app.bench(({ adapter }) => adapter.timer.core.memory)).toBe(0);
});
