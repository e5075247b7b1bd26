import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage, edgesOf } from './app-page.js';
import { SIZES } from './themes.js';

const preview = ({ page }: AppPage) => page.getByRole('region', { name: en.preview.title });

/** The angle of a surface in the sketch, as drawn. */
const turned = (app: AppPage, surface: string): Promise<string> =>
  preview(app)
    .locator(`[data-surface=${surface}]`)
    .evaluate((element) => (element as SVGElement).style.transform);

test('the model is shown under the timeline, both in one window, at the time of the selected cell', async () => {
  const app = await AppPage.simulated({ viewport: SIZES.desktop });
  await app.field('Function 6, S2').focus();
  await preview(app).getByText('Function 6 at 10.60 s').waitFor();
  expect(await turned(app, 'tailplane'), 'at the bunt the tailplane is turned down').toBe('rotate(16deg)');
  const above = await edgesOf(app.page.locator('.strip, header').first());
  const below = await edgesOf(app.actions);
  for (const part of [app.page.locator('.timeline-room').first(), preview(app)]) {
    const { top, bottom } = await edgesOf(part);
    expect(top, 'it lies below the strip').toBeGreaterThanOrEqual(above.bottom);
    expect(bottom, 'it lies above the command bar').toBeLessThanOrEqual(below.top);
  }

  await app.field('DT, S2').focus();
  await preview(app).getByText(en.preview.comesDown).waitFor();
  expect(await turned(app, 'tailplane'), 'at DT the tailplane is turned all the way up').toBe('rotate(-42deg)');
  await app.type('DT, S2', '56');
  await app.field('DT time').focus();
  await preview(app).getByText(en.findings['dt-moves-nothing']).waitFor();
});
