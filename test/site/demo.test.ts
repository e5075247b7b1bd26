import { expect, test } from 'vitest';
import { AppPage } from './app-page.js';

/** What M1 of each simulated timer holds, as far as it is looked at here. */
const HELD = {
  F1Q: { tailplane: [48, 44, 46, 50, 52, 30, 24, 40, 54, 56, 95], dt: '3:00', rudder2: 64, wingAtDt: 88 },
  F1B: { tailplane: [40, 36, 42, 46, 48, 50, 52, 55, 57, 57, 100], dt: '3:00', rudder2: 68, wingAtDt: 80 },
  F1E: { tailplane: [52, 55, 55, 55, 55, 55, 55, 55, 55, 55, 110], dt: '4:00', rudder2: 78, wingAtDt: 65 },
};

for (const name of ['F1Q', 'F1B', 'F1E'] as const) {
  test(`a pilot without a timer tries a simulated ${name}: reads, edits, writes, and sees it verified`, async () => {
    const app = await AppPage.open();
    await app.trySimulated(name);
    await app.firmware.waitFor();
    const held = HELD[name];
    await expect.poll(() => app.positions('S2')).toEqual(held.tailplane.map(String));
    await expect.poll(() => app.valueOf('DT')).toBe(held.dt);

    await app.type('DT time', '5:00');
    await app.type('Function 2, S1', '0');
    await app.type('DT, S3', '130');
    await expect.poll(() => app.valueOf('DT'), { message: 'the large figure follows' }).toBe('5:00');
    await app.text('3 changes').waitFor();

    await app.review();
    await expect
      .poll(() => app.difference())
      .toEqual([
        `DT time | ${held.dt} min | 5:00 min`,
        `Function 2, S1 | ${held.rudder2} | 0`,
        `DT, S3 | ${held.wingAtDt} | 130`,
      ]);
    const start = app.dialog.getByRole('button', { name: 'Write 3 changes' });
    expect(await start.isDisabled(), 'not before the tick').toBe(true);
    expect(await app.sets(), 'nothing yet').toEqual([]);
    await app.tickSafety();
    await start.click();
    await app.result('Verified.');
    await app.close();

    expect(await app.sets()).toEqual(['SETTIMERS', 'SETSERVO', 'SETSERVO']);
    const sent = await app.sent();
    const content = ['GETTIMERS', 'GETSERVOPOS', ...(name === 'F1Q' ? ['GETLOWRPM'] : [])];
    const reading = ['GETSWVER', 'GETMEMORY', ...content, ...content, 'GETMEMORY', 'GETSWVER'];
    expect(sent.slice(sent.lastIndexOf('SETSERVO') + 1), 'read back').toEqual(reading);
    await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
    await app.readAgain();
    await expect.poll(() => app.valueOf('Function 2, S1')).toBe('0');
    await expect.poll(() => app.valueOf('DT, S3')).toBe('130');
  });
}

test('the motor stop of an F1Q stands large beside DT, and is the start time', async () => {
  const app = await AppPage.open();
  await app.trySimulated('F1Q');
  await expect.poll(() => app.valueOf('Motor stop')).toBe('10.0');
  await app.type('Motor stop', '9.5');
  await expect.poll(() => app.valueOf('Motor stop time')).toBe('9.5');
});

test('the reserved start time of an F1B is edited only on purpose', async () => {
  const app = await AppPage.open();
  await app.trySimulated('F1B');
  await expect.poll(() => app.field('Start time').isEditable()).toBe(false);
  await app.button('Edit the reserved time').click();
  await expect.poll(() => app.field('Start time').isEditable()).toBe(true);
  await app.page.keyboard.type('1');
  await expect.poll(() => app.valueOf('Start time')).toBe('1');
});

test('the safety is asked for once in a connection', async () => {
  const app = await AppPage.open();
  await app.trySimulated('F1Q');
  await app.type('Function 1, S1', '1');
  await app.write();
  await app.result('Verified.');
  await app.close();
  await app.type('Function 1, S1', '2');
  await app.review();
  await expect.poll(() => app.dialog.getByRole('button', { name: 'Write 1 change' }).isEnabled()).toBe(true);
});

test('what may cost a model has to be acknowledged before it is written', async () => {
  const app = await AppPage.open();
  await app.trySimulated('F1Q');
  await app.type('Motor stop', '4:00');
  await app.review();
  await app.tickSafety();
  const start = app.dialog.getByRole('button', { name: 'Write 1 change' });
  expect(await start.isDisabled()).toBe(true);
  await app.dialog.getByText('The motor stops after DT (3:00)').waitFor();
  await app.dialog.getByRole('checkbox', { name: 'I have read this' }).check();
  await start.click();
  await app.result('Verified.');
});

test('each memory is read as it is chosen, and keeps its own edits', async () => {
  const app = await AppPage.open();
  await app.trySimulated('F1Q');
  await app.type('Function 3, S2', '77');
  await app.fly('M2');
  await expect.poll(() => app.valueOf('Motor stop'), { message: 'M2 is for wind' }).toBe('9.5');
  await expect.poll(() => app.valueOf('Function 3, S2')).toBe('48');
  await app.says('Your edits of the other memory are kept.');
  await app.fly('M1');
  await app.says('Earlier edits for this memory are back.');
  await expect.poll(() => app.valueOf('Function 3, S2')).toBe('77');
});

test('by keyboard alone: try, edit DT, write, verify', async () => {
  const app = await AppPage.open();
  const { keyboard } = app.page;
  /** Tabs until the element with this name has the focus. */
  const tabTo = async (name: RegExp): Promise<void> => {
    for (let i = 0; i < 200; i++) {
      await keyboard.press('Tab');
      const focused = await app.page.evaluate(() => {
        const { activeElement: at } = document;
        return at?.getAttribute('aria-label') ?? at?.closest('label')?.textContent ?? at?.textContent ?? '';
      });
      if (name.test(focused)) return;
    }
    throw new Error(`Tab never reached ${name}`);
  };
  await tabTo(/^Try a simulated F1Q timer$/);
  await keyboard.press('Enter');
  await app.hasRead();
  await tabTo(/^DT time$/);
  await keyboard.type('240');
  await tabTo(/^240 s, 4:00$/);
  await keyboard.press('Enter');
  await tabTo(/^Write 1…$/);
  await keyboard.press('Enter');
  await app.dialog.waitFor();
  await tabTo(/^The propeller is off/);
  await keyboard.press('Space');
  await tabTo(/^Write 1 change$/);
  await keyboard.press('Enter');
  await app.result('Verified.');
  await tabTo(/^Close$/);
  await keyboard.press('Enter');
  await app.dialog.waitFor({ state: 'hidden' });
  await expect.poll(() => app.valueOf('DT')).toBe('4:00');
  expect(await app.sets()).toEqual(['SETTIMERS']);
});
