import type { Locator } from 'playwright';
import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
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
  await preview(app).getByText(en.findings['dt-moves-nothing']).waitFor();
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
