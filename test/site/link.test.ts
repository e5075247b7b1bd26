import { describe, expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { AppPage } from './app-page.js';
import { edited, edits, held } from './edited.js';

describe('finding the timer', () => {
  test('one that answers only at 19200 baud is found, and later tried there first', async () => {
    const app = await AppPage.open({ bench: { granted: true, answersAt: 19200 } });
    await app.goTo('Settings');
    await app.button(en.of(en.header.connect, en.link.portNames.ftdi)).click();
    await app.isReady();
    expect(await app.bench(({ rates }) => rates)).toEqual([9600, 19200]);
    await app.button('Disconnect').click();
    await app.connect();
    expect(await app.bench(({ rates }) => rates)).toEqual([9600, 19200, 19200]);

    await app.reload();
    await app.connect();
    expect(await app.bench(({ rates }) => rates)).toEqual([19200]);
    await app.showAbout();
    await app.text(/·\s19200\sbaud$/).waitFor();
  });

  test('one that sleeps is asked quietly, and read as soon as its switch is pressed', async () => {
    const app = await AppPage.open({ bench: {} });
    await app.bench((bench) => bench.sleep());
    await app.button('Connect').click();
    await app.text(/^No answer for /).waitFor();
    await app.text(en.link.status.searching).waitFor();
    await app.page.getByRole('heading', { name: en.link.stages.steps.near }).waitFor();
    await app.bench((bench) => bench.press());
    await app.hasRead();
    await app.text(/^No answer for /).waitFor({ state: 'detached' });
  });
});

describe('the adapter comes back', () => {
  test('as another port, as with a cable: without a click, with the edits', async () => {
    const app = await edited();
    await app.bench((bench) => bench.adapter.unplug());
    await app.says(en.link.lost.title);
    expect(await app.button(/^Write( \d+ changes?)?…$/).isDisabled()).toBe(true);
    await expect.poll(() => edits(app)).toEqual(['4:00', '7']);
    await app.bench((bench) => bench.replug());
    await app.isReady();
    await expect.poll(() => edits(app)).toEqual(['4:00', '7']);
    await app.write();
    await app.result('Verified.');
    expect(await held(app)).toEqual([24000, 7]);
  });

  test('and the timer holds other values: the interrupted write is shown beside them', async () => {
    const app = await edited();
    await app.bench((bench) => {
      bench.adapter.unplug();
      bench.content.times[10] = 21000;
      bench.replug();
    });
    await app.says(en.notes.moved.title);
    await app.isReady();
    await app.review();
    const conflicts = app.dialog.getByRole('table').first();
    await expect
      .poll(() => conflicts.locator('thead th').allInnerTexts())
      .toEqual(['Value', 'Was read', 'Timer holds']);
    await expect
      .poll(() => conflicts.locator('tbody tr').locator('th, td').allInnerTexts())
      .toEqual(['DT', '3:00 min', '3:30 min']);
    await app.tickSafety();
    await app.dialog.getByRole('button', { name: 'Write 2 changes' }).click();
    await app.result('Verified.');
    expect(await held(app)).toEqual([24000, 7]);
  });
});

describe('the port is taken', () => {
  test('by another program: the page says what to do, with a command to copy and a link to all steps', async () => {
    const app = await AppPage.open({
      bench: { granted: true },
      permissions: ['clipboard-read', 'clipboard-write'],
      // The steps depend on the system that the browser names.
      before: () =>
        Object.defineProperty(navigator, 'userAgentData', {
          value: { platform: 'Linux', brands: [] },
          configurable: true,
        }),
    });
    await app.bench((bench) => bench.setBusy(true));
    await app.button('Connect').click();
    await app.says(en.link.refused);
    await app.page.getByText(en.help.title).first().click();
    const linux = app.page.getByRole('listitem').filter({ hasText: en.help.steps.linux });
    await linux.getByRole('button', { name: en.copy }).click();
    await linux.getByText(en.copied).waitFor();
    expect(await app.page.evaluate(() => navigator.clipboard.readText())).toBe('sudo usermod -a -G dialout $USER');
    const all = app.page.getByRole('link', { name: en.help.page }).first();
    const page = await app.page.request.get(new URL((await all.getAttribute('href')) ?? '', app.page.url()).href);
    expect(await page.text()).toContain('brltty');
  });
});

describe('about this timer', () => {
  test('times with exchanged bytes bring a question, are shown, and remembered', async () => {
    const app = await AppPage.open({ bench: { granted: true, quirks: { bigEndianTimes: true } } });
    await app.connect();
    await app.says('The times of this timer fall from row to row.');
    await app.button(en.byteOrder.exchange).click();
    await expect.poll(() => app.valueOf('DT time')).toBe('3:00');
    await app.showAbout();
    await app.text(en.aboutTimer.quirkNames['times-big-endian']).waitFor();
    const assumed = app.page.getByRole('checkbox', { name: en.aboutTimer.assumptions.bigEndianTimes });
    await expect.poll(() => assumed.isChecked()).toBe(true);

    await app.goTo('Program');
    await app.reload();
    await app.connect();
    await expect.poll(() => app.valueOf('DT time')).toBe('3:00');
    await expect.poll(() => app.text('The times of this timer fall from row to row.').count()).toBe(0);
  });

  test('rounded times are noticed by writing', async () => {
    const app = await AppPage.open({ bench: { quirks: { timeStep: 10 } } });
    await app.connect();
    await app.type('DT time', '4:00.05');
    await app.write();
    await app.result(en.write.differs.title);
    await app.close();
    await app.showAbout();
    await app.text(en.aboutTimer.quirkNames['times-rounded']).waitFor();
  });
});

test('with one byte in a hundred damaged, a timer is read, written and verified, and the repeats are shown', async () => {
  const app = await AppPage.open({ bench: { damage: 0.01 } });
  await app.button('Connect').click();
  await app.table.waitFor();
  await app.page.locator('button:not(:disabled, [aria-disabled=true])', { hasText: /^Read again$/ }).waitFor();
  await app.type('DT time', '4:00');
  await app.type('Function 2, S1', '7');
  await app.button(/^Write( \d+ changes?)?…$/).click();
  await app.dialog.waitFor();
  await app.tickSafety();
  await app.dialog.getByRole('button', { name: 'Write 2 changes' }).click();
  await app.dialog.getByRole('alert').getByText('Verified.').waitFor();
  expect(await held(app)).toEqual([24000, 7]);
});
