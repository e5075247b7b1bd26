import { expect, test } from 'vitest';
import { LANGUAGES } from '../../src/app/messages/first.js';
import { en } from '../tools/en.js';
import { OVER, outOfReach } from '../tools/in-reach.js';
import { AppPage } from './app-page.js';
import { showTheme } from './themes.js';

type Size = readonly [width: number, height: number];
/** For touch: two phones, one of them on its side, and a tablet. */
const BY_TOUCH: readonly Size[] = [
  [360, 740],
  [390, 844],
  [844, 390],
  [820, 1180],
];
/** With a mouse: three laptops, and the first of them at 200 and 400 per cent. */
const BY_MOUSE: readonly Size[] = [
  [1280, 800],
  [1366, 650],
  [1440, 900],
  [640, 400],
  [320, 256],
];

const faults: string[] = [];

/** What is still out of reach when the page has come to rest: it scrolls back to the field after its words changed. */
async function lasting(app: AppPage): Promise<readonly string[]> {
  const found = await app.page.evaluate(outOfReach, OVER);
  if (found.length === 0) return found;
  await app.page.waitForTimeout(500);
  return await app.page.evaluate(outOfReach, OVER);
}

/** @param least where words have the least room: looked at in each language. */
async function look(app: AppPage, sizes: readonly Size[], least: Size, state: string): Promise<void> {
  for (const [width, height] of sizes) {
    await app.resize({ width, height });
    for (const fault of await app.page.evaluate(outOfReach, OVER))
      faults.push(`${state}, ${width}x${height}: ${fault}`);
  }
  await app.resize({ width: least[0], height: least[1] });
  // English comes first, and is needed again for the way to the next state.
  for (const language of [...LANGUAGES.slice(1), 'en']) {
    await app.speak(language);
    for (const fault of await lasting(app)) faults.push(`${state}, ${least.join('x')}, ${language}: ${fault}`);
  }
  const [first] = sizes;
  // Where room is scarce: the strip on a phone, the rail on a tablet and a laptop.
  for (const [width, height] of sizes.filter((size) => size === first || size[0] === 820)) {
    await app.resize({ width, height });
    await app.page.evaluate(spreadText, true);
    await drawn(app);
    for (const fault of await app.page.evaluate(outOfReach, OVER))
      faults.push(`${state}, ${width}x${height} with spread text: ${fault}`);
    await app.page.evaluate(spreadText, false);
  }
  if (first) await app.resize({ width: first[0], height: first[1] });
}

const drawn = (app: AppPage): Promise<unknown> =>
  app.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

/** Text with as much space as a reader may ask for: WCAG 1.4.12. Runs in the page. */
function spreadText(on: boolean): void {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(`
    * { line-height: 1.5 !important; letter-spacing: 0.12em !important; word-spacing: 0.16em !important; }
    p { margin-block-end: 2em !important; }
  `);
  document.adoptedStyleSheets = on ? [sheet] : [];
}

test.each([
  ['a finger', BY_TOUCH, [320, 640], { hasTouch: true, isMobile: true }],
  ['a mouse', BY_MOUSE, [1280, 800], {}],
] as const)(
  'all that is there can be read and pressed with %s, in each view, size and language',
  async (_, sizes, least, options) => {
    faults.length = 0;
    const [first] = sizes;
    const [width, height] = first as Size;
    const app = await AppPage.open({ bench: {}, viewport: { width, height }, ...options });
    // The largest letters.
    await showTheme(app, 'sun');
    const { page } = app;
    const dialog = page.getByRole('dialog');
    const see = (state: string): Promise<void> => look(app, sizes, least, state);
    const shut = async (): Promise<void> => {
      await page.keyboard.press('Escape');
      await dialog.waitFor({ state: 'hidden' });
    };
    await app.button('Connect').first().waitFor();
    await see('start');
    await app.button(en.newProgram.title).click();
    await dialog.waitFor();
    await see('new program');
    await shut();
    await app.bench((bench) => bench.dismissChooser());
    await app.button('Connect').click();
    await app.says(en.connection['nothing-chosen'].title);
    await see('no port');
    await app.bench((bench) => bench.chooseAdapter());
    await app.connect();
    await see('program');
    await app.type(en.program.motorStopTime, '39.95');
    await app.type('Function 1 time', '1:30.25');
    await app.type('DT time', '10:00');
    for (const servo of ['S1', 'S2', 'S3']) await app.type(`Function 2, ${servo}`, '130');
    await app.type(en.program.idleThrottle, 'x');
    await see('program with edits and errors');
    await app.type(en.program.idleThrottle, '30');
    await app.button('Tools for Function 4').click();
    await see('tools of a row');
    await page.keyboard.press('Escape');
    await app.showFigures();
    await see('what has no room in the strip');
    const close = app.page.locator('.strip-close');
    if (await close.isVisible()) await close.click();
    await page.keyboard.press('Control+k');
    await dialog.waitFor();
    await see('commands');
    await shut();
    await app.review();
    await see('difference');
    for (const box of await app.dialog.getByRole('checkbox').all()) await box.check();
    await app.dialog.getByRole('button', { name: /^Write/ }).click();
    await app.result('Verified.');
    await see('verdict');
    await app.close();
    for (const view of ['Memories', 'Bench', 'Library', 'Line', 'Settings'] as const) {
      await app.goTo(view);
      await see(view);
    }
    await app.text(en.aboutTimer.title).click();
    await app.text(en.ports.settings).click();
    await see('settings, all open');
    await page.evaluate(() => location.assign('#settings/settle'));
    await page.getByRole('checkbox', { name: en.settle.safe }).check();
    await app.button(en.settle.readIt).click();
    await app.text(en.settle.unknown).waitFor();
    await see('a question of the walk');
    for (let i = 0; i < 4; i++) await page.locator('.settle-step').getByRole('button', { name: en.next }).click();
    await see('a step that moves servos');
    await page.evaluate(() => location.assign('#settings'));
    await app.button(/^Delete/).click();
    await dialog.waitFor();
    await see('delete');
    await dialog.getByRole('button', { name: 'Cancel' }).click();
    await app.goTo('Bench');
    await page.getByRole('checkbox', { name: /^The propeller/ }).check();
    await app.button('Function 2').click();
    await app.text('Servos at function 2').first().waitFor();
    await page.getByRole('switch').click();
    // A step before following is on waits for Write.
    await page.getByRole('switch', { checked: true }).waitFor();
    await app.button('−1: Function 2, S1').click();
    await app.text('1 tried in the timer').first().waitFor({ state: 'attached' });
    await see('bench, following');
    await page.getByRole('switch').first().click();
    await app.button('Keep it').first().waitFor();
    await see('bench, tried');
    await app.button('Keep it').first().click();
    await app.goTo('Memories');
    await app.button(en.overview.readAll).click();
    await app.page.getByText('memories were read').waitFor();
    await see('all read');
    await app.page.getByLabel('Copy to…: M2', { exact: true }).click();
    await see('memories, read');
    await app.button('Compare with M1: M3').click();
    await see('memories compared');
    await app.goTo('Memories');
    await app.page.getByLabel('Copy to…: M1', { exact: true }).click();
    await app.button('Copy M1 to M3').click();
    await dialog.getByRole('checkbox').first().waitFor();
    await see('copy');
    await shut();
    await app.goTo('Program');
    await app.bench((bench) => bench.adapter.unplug());
    await app.says(en.link.lost.title);
    await see('unplugged');
    expect(faults).toEqual([]);
  },
);
