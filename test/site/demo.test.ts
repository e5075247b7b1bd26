import { expect, test } from 'vitest';
import { AppPage } from './app-page.js';

/** The values of M1 of each simulated timer that these tests use. */
const HELD = {
  F1Q: { tailplane: [48, 44, 46, 50, 52, 30, 24, 40, 54, 56, 95], dt: '3:00', rudder2: 64, wingAtDt: 88 },
  F1B: { tailplane: [40, 36, 42, 46, 48, 50, 52, 55, 57, 57, 100], dt: '3:00', rudder2: 68, wingAtDt: 80 },
  F1E: { tailplane: [52, 55, 55, 55, 55, 55, 55, 55, 55, 55, 110], dt: '4:00', rudder2: 78, wingAtDt: 65 },
};

for (const name of ['F1Q', 'F1B', 'F1E'] as const) {
  test(`a pilot without a timer tries a simulated ${name}: reads, edits, writes, and sees it verified`, async () => {
    const app = await AppPage.open({ isMoving: true });
    await app.trySimulated(name);
    await app.firmware.waitFor();
    const held = HELD[name];
    await expect.poll(() => app.positions('S2')).toEqual(held.tailplane.map(String));
    await expect.poll(() => app.valueOf('DT time')).toBe(held.dt);

    await app.type('DT time', '5:00');
    await app.type('Function 2, S1', '0');
    await app.type('DT, S3', '130');
    await app.changes(3).waitFor();

    await app.review();
    await expect
      .poll(() => app.difference())
      .toEqual([
        `DT | ${held.dt} min | 5:00 min`,
        `Function 2, S1 | ${held.rudder2} | 0`,
        `DT, S3 | ${held.wingAtDt} | 130`,
      ]);
    const start = app.dialog.getByRole('button', { name: 'Write 3 changes' });
    expect(await start.isDisabled(), 'a write can start only after the tick').toBe(true);
    expect(await app.sets(), 'nothing is sent before the write starts').toEqual([]);
    await app.tickSafety();
    await start.click();
    await app.result('Verified.');
    await app.close();

    expect(await app.sets()).toEqual(['SETTIMERS', 'SETSERVO', 'SETSERVO']);
    const sent = await app.sent();
    const content = ['GETTIMERS', 'GETSERVOPOS', ...(name === 'F1Q' ? ['GETLOWRPM'] : [])];
    const reading = ['GETSWVER', 'GETMEMORY', ...content, ...content, 'GETMEMORY', 'GETSWVER'];
    expect(sent.slice(sent.lastIndexOf('SETSERVO') + 1), 'after the last SET everything is read back').toEqual(reading);
    await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
    await app.readAgain();
    await expect.poll(() => app.valueOf('Function 2, S1')).toBe('0');
    await expect.poll(() => app.valueOf('DT, S3')).toBe('130');
  });
}
