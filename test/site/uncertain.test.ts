import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';

const HOLDS = 'holds: DT is 3:00 min or 6:00 min. Do not fly before it is read.';

/** The band says so, and nothing on the page says what is not known. */
async function isUncertain(app: AppPage, when: string): Promise<void> {
  await app.page.getByRole('region', { name: 'Not certain' }).getByText(HOLDS).waitFor();
  for (const lie of [/^No changes/, /^was 3:00/, /They have not been written/, /^As in the timer/, /^Timer holds$/]) {
    expect(await app.text(lie).count(), `${when}: the page must not say ${lie}`).toBe(0);
  }
}

test('a cable pulled before the answer to a write makes the timer uncertain until it is read', async () => {
  const app = await AppPage.connected();
  await app.type('DT time', '6:00');
  await app.bench((bench) => bench.unplugAt('SETTIMERS'));
  await app.write();
  await app.result(en.write.unknown.title);
  expect(await app.bench(({ content }) => content.times[10]), 'the timer has taken the DT').toBe(36_000);

  await app.close();
  await isUncertain(app, 'after Close');
  await app.table.getByText('last read 3:00').waitFor();
  await app.button('Undo all').click();
  await isUncertain(app, 'after Undo all');
  await app.button(en.header.stop).click();
  await app.button('Connect').first().waitFor();
  await isUncertain(app, 'after Stop');
  await app.kept();
  await app.reload();
  await isUncertain(app, 'after a reload');

  // The browser has crashed: what the page would have said in leaving was never said.
  const survivor = await app.waitingTab();
  await app.page.close({ runBeforeUnload: false });
  await isUncertain(survivor, 'after a crash');
  await survivor.bench(({ content }) => {
    content.times[10] = 36_000;
  });
  await survivor.button(en.knowledge.connect).click();
  await survivor.isReady();
  await expect.poll(() => survivor.page.getByRole('region', { name: 'Not certain' }).count()).toBe(0);
  await expect.poll(() => survivor.valueOf('DT time')).toBe('6:00');
  await survivor.text(/^As in the timer, read \d\d:\d\d$/).waitFor();
});
