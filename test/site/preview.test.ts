import type { Locator } from 'playwright';
import { expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { AppPage } from './app-page.js';
import { SIZES } from './themes.js';

const preview = ({ page }: AppPage) => page.getByRole('region', { name: en.preview.title });

/** The angle of a surface in the sketch, as drawn. */
const turned = (app: AppPage, surface: string): Promise<string> =>
  preview(app)
    .locator(`[data-surface=${surface}]`)
    .evaluate((element) => (element as SVGElement).style.transform);

/** Controls that are too small for a finger. */
const tooSmall = (part: Locator): Promise<string[]> =>
  part.locator('button, select, input').evaluateAll((controls) =>
    controls
      .filter((control) => {
        const { width, height } = control.getBoundingClientRect();
        return width > 0 && (width < 44 || height < 44);
      })
      .map((control) => control.outerHTML),
  );

test('the model is shown under the timeline, both in one window, at the time of the selected cell', async () => {
  const app = await AppPage.open({ viewport: SIZES.desktop });
  await app.trySimulated('F1Q');
  await app.field('Function 6, S2').focus();
  await preview(app).getByText('Function 6 at 10.60 s').waitFor();
  expect(await turned(app, 'tailplane'), 'at the bunt the tailplane is turned down').toBe('rotate(16deg)');
  const above = (await app.page.locator('.strip, header').first().boundingBox()) ?? { y: 0, height: 0 };
  const below = await app.actions.boundingBox();
  for (const part of [app.page.locator('.timeline-room').first(), preview(app)]) {
    const box = await part.boundingBox();
    expect(box?.y, 'it lies below the strip').toBeGreaterThanOrEqual(above.y + above.height);
    expect((box?.y ?? 0) + (box?.height ?? 0), 'it lies above the command bar').toBeLessThanOrEqual(below?.y ?? 0);
  }

  await app.field('DT, S2').focus();
  await preview(app).getByText(en.preview.comesDown).waitFor();
  expect(await turned(app, 'tailplane'), 'at DT the tailplane is turned all the way up').toBe('rotate(-42deg)');
  await app.type('DT, S2', '56');
  await app.field('DT time').focus();
  await preview(app).getByText(en.findings['dt-moves-nothing']({})).waitFor();
});

test('the flight can be played with keys alone, and the timeline shows the time', async () => {
  const app = await AppPage.open({ viewport: SIZES.desktop });
  await app.trySimulated('F1Q');
  const cursor = app.page.locator('.crosshair');
  await expect.poll(() => cursor.count(), { message: 'there is no time mark before the flight is played' }).toBe(0);
  await preview(app).getByRole('combobox', { name: 'Speed' }).selectOption('20×');
  await preview(app).getByRole('button', { name: 'Play' }).press('Enter');
  await preview(app).getByText('3:03 min', { exact: true }).waitFor();
  await cursor.first().waitFor();
  const back = preview(app).getByRole('button', { name: en.previous });
  await back.press('Enter');
  await preview(app).getByText('3:00 min', { exact: true }).waitFor();
  await back.press('Enter');
  await preview(app).getByText('Function 9 at 20.00 s').waitFor();
});

test('the pilot names the servos once: on the sketch, in the lanes, and after a reload', async () => {
  const app = await AppPage.open({ viewport: SIZES.desktop });
  await app.trySimulated('F1Q');
  const lanes = app.page.locator('.lane-names');
  await app.button(en.preview.nameServos).click();
  await app.page.getByRole('combobox', { name: 'S1 moves' }).selectOption(en.preview.duties.other);
  await app.page.getByRole('textbox', { name: 'Name for what S1 moves' }).fill('Left flap');
  await app.page.getByRole('spinbutton', { name: 'S2, one end in steps' }).fill('131');
  await app.button('Save').click();
  await expect
    .poll(() => app.page.getByRole('dialog').isVisible(), { message: 'the dialog stays open: there is no step 131' })
    .toBe(true);
  await app.page.getByRole('spinbutton', { name: 'S2, one end in steps' }).fill('20');
  await app.button('Save').click();
  await app.page.getByRole('dialog').waitFor({ state: 'hidden' });
  await lanes.getByText('Left flap').waitFor();
  await app.type('DT time', '4:00');
  await app.kept();
  await app.reload();
  await lanes.getByText('Left flap').waitFor();
  await preview(app).getByText('Tailplane').waitFor();
  await app.button(en.preview.nameServos).click();
  await expect.poll(() => app.page.getByRole('spinbutton', { name: 'S2, one end in steps' }).inputValue()).toBe('20');
});

test('on a phone the picture includes the preview, which works by finger', async () => {
  const app = await AppPage.open({ viewport: SIZES.phone, hasTouch: true });
  await app.trySimulated('F1B');
  await app.button('Picture').click();
  await preview(app).getByText('Launch').waitFor();
  expect(await tooSmall(preview(app))).toEqual([]);
  await app.expectNoSidewaysScrolling();
  await app.button(en.preview.nameServos).tap();
  expect(await tooSmall(app.page.getByRole('dialog'))).toEqual([]);
  await app.expectNoSidewaysScrolling();
});
