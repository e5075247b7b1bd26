import { describe, expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage, FIRST_POSITIONS, isInSight } from './app-page.js';
import { edited, held } from './edited.js';

describe('through a serial port', () => {
  test('a pilot connects, reads, edits, writes, and sees it verified', async () => {
    const app = await AppPage.open({ bench: {} });
    expect(await app.bench(({ opened }) => opened), 'no port is opened without a click').toBeNull();
    await app.connect();
    expect(await app.bench(({ opened }) => opened)).toMatchObject({
      baudRate: 9600,
      dataBits: 8,
      stopBits: 1,
      parity: 'none',
      bufferSize: 16384,
    });
    for (const servo of ['S1', 'S2', 'S3']) await expect.poll(() => app.positions(servo)).toEqual(FIRST_POSITIONS);

    await app.type('DT time', '4:00');
    await app.type('Function 2, S1', '7');
    await app.type('Function 9, S3', '130');
    await app.write();
    await app.result('Verified.');
    await app.close();
    expect(await app.sets()).toEqual(['SETTIMERS', 'SETSERVO', 'SETSERVO']);
    expect(await app.bench(({ sets }) => sets), 'the timer got the same requests').toEqual(await app.sets());
    const { times, positions } = await app.bench(({ content }) => content);
    expect([times[10], positions[0]?.[2], positions[2]?.[9]]).toEqual([24000, 7, 130]);

    await app.button('Disconnect').click();
    await app.button('Connect').waitFor();
    await expect.poll(() => app.bench(({ opened }) => opened)).toBeNull();
  });
});

describe('the plug is pulled', () => {
  test('during a write: nothing is called verified, and the write can be finished later', async () => {
    const app = await edited();
    await app.bench((bench) => bench.unplugAt('SETSERVO'));
    await app.write();
    await app.result(en.write.unknown.title);
    await app.close();
    await app.says(en.link.lost.title);
    await expect
      .poll(async () => [await app.valueOf('DT time'), await app.valueOf('Function 2, S1')])
      .toEqual(['4:00', '7']);

    await app.bench((bench) => bench.replug());
    await app.isReady();
    await app.review();
    const safety = app.dialog.getByRole('checkbox', { name: 'The propeller is off' });
    expect(await safety.isChecked(), 'the safety is asked again on a new connection').toBe(false);
    await app.tickSafety();
    await app.dialog.getByRole('button', { name: /^(Write|Read back)/ }).click();
    await app.result('Verified.');
    expect(await held(app)).toEqual([24000, 7]);
  });

  test('the message is visible, wherever the page is scrolled on a phone', async () => {
    const app = await AppPage.connected({ viewport: { width: 390, height: 844 } });
    await app.field('DT, S1').scrollIntoViewIfNeeded();
    await app.bench((bench) => bench.adapter.unplug());
    await app.says(en.link.lost.title);
    await expect.poll(() => isInSight(app.text(en.link.lost.title))).toBe(true);
  });
});

describe('an impatient pilot', () => {
  test('presses Escape again and again during a write: the result is still shown', async () => {
    const app = await edited();
    // A timer that sleeps makes the writing last long enough for a hand.
    await app.bench((bench) => bench.sleepAt('SETTIMERS'));
    await app.write();
    await expect.poll(() => app.bench(({ sets }) => sets.length)).toBeGreaterThan(0);
    for (let i = 0; i < 4; i++) await app.page.keyboard.press('Escape');
    await app.bench((bench) => bench.press());
    await app.isReady();
    await app.page.waitForFunction(() => document.querySelector('dialog [role=alert]'));
    await expect.poll(() => app.dialog.isVisible(), { message: 'the dialog stays open' }).toBe(true);
    await app.close();
    await app.review();
  });
});

describe('without Web Serial', () => {
  const without = (): unknown => Reflect.deleteProperty(Navigator.prototype, 'serial');

  test('the page names the browsers that have it; edits of a simulated timer are kept, and can be written', async () => {
    const app = await AppPage.open({ before: without });
    await app.text(en.unsupportedHere.advice).waitFor();
    await expect.poll(() => app.button('Connect').count()).toBe(0);
    await app.trySimulated('F1Q');
    await app.type('Function 2, S1', '7');
    await app.kept();
    await app.reload();
    await expect.poll(() => app.valueOf('Function 2, S1')).toBe('7');
    await app.button(en.program.connectAndWrite).click();
    await app.dialog.waitFor();
    await expect.poll(() => app.difference()).toEqual([expect.stringMatching(/^Function 2, S1 .* 7$/)]);
    await app.tickSafety();
    await app.dialog.getByRole('button', { name: en.write.start({ count: 1 }) }).click();
    await app.result('Verified.');
  });
});
