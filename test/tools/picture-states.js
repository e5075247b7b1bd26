// The states of the page for the pictures, and how each is reached. Run by pictures.js.

import { readFileSync } from 'node:fs';

/** @typedef {import('playwright').Page} Page */

/**
 * @typedef {object} State
 * @property {string} title
 * @property {(page: Page) => Promise<void>} reach
 * @property {import('../site/workbench.js').WorkbenchOptions} [bench] what replaces the browser's serial
 *   ports, if the state does not use the simulated timer of the page
 */

/** @param {Page} page @param {string | RegExp} name */
const press = (page, name) => page.getByRole('button', { name }).first().click();

/** @param {Page} page @param {string} field @param {string} text */
async function enter(page, field, text) {
  const box = page.getByRole('textbox', { name: field, exact: true });
  await box.fill(text);
  await box.press('Enter');
}

/** @param {Page} page @param {string} view */
const goTo = (page, view) => page.evaluate((hash) => location.assign(hash), `#${view}`);

/** @param {Page} page */
const toTop = (page) => page.evaluate(() => scrollTo(0, 0));

/** @param {Page} page */
const settled = (page) => page.locator('#app:has(.link-state.on) > main[aria-busy=false]').waitFor();

/** @param {Page} page */
async function connect(page) {
  await press(page, 'Try a simulated F1Q timer');
  await settled(page);
}

/** @param {Page} page @param {(page: Page) => Promise<void>} reach the timer that is changed */
async function change(page, reach = connect) {
  await reach(page);
  await enter(page, 'DT time', '6:00');
  await enter(page, 'Function 4, S2', '70');
  await toTop(page);
}

/** @param {Page} page */
async function review(page) {
  await change(page);
  await press(page, /^Write( \d+ changes?)?…$/);
  await page.getByRole('dialog').waitFor();
}

/** A DT for trimming is written. @param {Page} page */
async function trim(page) {
  await connect(page);
  await enter(page, 'DT time', '20 s');
  await press(page, /^Write( \d+ changes?)?…$/);
  await promise(page);
  await press(page, /^Write \d+ changes?$/);
  await page.getByText('Verified.').waitFor();
}

/** Shares the program on the screen, through the list of commands. @param {Page} page */
async function offer(page) {
  await command(page, 'share');
  await page.getByRole('dialog', { name: /^Share/ }).waitFor();
}

/** @param {Page} page */
const promise = (page) =>
  page
    .getByRole('checkbox', { name: /^The propeller/ })
    .first()
    .check();

/** @param {Page} page */
async function follow(page) {
  await connect(page);
  await goTo(page, 'bench');
  await promise(page);
  await page.getByRole('switch', { name: 'Servos follow' }).click();
  await page.getByRole('switch', { name: 'Servos follow', checked: true }).waitFor();
  await goTo(page, 'program');
  await enter(page, 'Function 4, S1', '60');
  await press(page, 'Move the servos to function 4');
  await page.getByText('1 tried in the timer').first().waitFor();
}

/** Opens what has no room in the strip of a phone. @param {Page} page */
async function showFigures(page) {
  const figures = page.locator('.strip-more[aria-expanded=false]');
  if (await figures.isVisible()) await figures.click();
}

/** Shows the picture of the program, which takes the place of the table on a phone. @param {Page} page */
async function showPicture(page) {
  const picture = page.getByRole('button', { name: 'Picture', exact: true });
  if (await picture.isVisible()) await picture.click();
}

/** @param {Page} page */
async function disconnect(page) {
  const button = page.getByRole('button', { name: 'Disconnect' }).first();
  if (!(await button.isVisible())) await showFigures(page);
  await button.click();
}

/** @param {Page} page @param {string} memory */
async function lookAt(page, memory) {
  if (!(await page.locator('.memories').isVisible())) await showFigures(page);
  await page.getByRole('radio', { name: memory }).click({ force: true });
}

/** Reads all memories in their view. @param {Page} page */
async function readAll(page) {
  await connect(page);
  await goTo(page, 'memories');
  await press(page, 'Read and keep all');
  await page.getByText('memories were read').waitFor();
  await settled(page);
}

/** For a page in which a workbench replaces the browser's serial ports. @param {Page} page */
async function connectPort(page) {
  await press(page, 'Connect');
  await settled(page);
}

/** @param {Page} page */
async function conflict(page) {
  await change(page, connectPort);
  await page.evaluate(() => {
    window.workbench.content.times[10] = 21000;
  });
  await press(page, /^Write( \d+ changes?)?…$/);
  await page.getByRole('dialog').waitFor();
}

/** A file of a library: the example of the docs. */
const [, example = ''] =
  /```json library\n([^`]+)```/.exec(readFileSync(new URL('../../docs/file-format.md', import.meta.url), 'utf8')) ?? [];

/** Drops a file on the library. @param {Page} page @param {string} text */
async function drop(page, text) {
  await goTo(page, 'library');
  await page.getByRole('button', { name: 'Import…' }).waitFor();
  await page.evaluate((content) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([content], 'field.sidus.json'));
    for (const type of ['dragover', 'drop'])
      document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
  }, text);
}

/** Imports a file of one model with one setting. @param {Page} page @param {string} [text] */
async function take(page, text = example) {
  await drop(page, text);
  await press(page, 'Import 2');
  await page.getByText(/^Imported from/).waitFor();
}

/** A library of one model with one setting. @param {Page} page */
async function fill(page) {
  await take(page);
  await press(page, 'Dismiss');
}

/** Runs a command of the list of commands, found by its words. @param {Page} page @param {string} words */
async function command(page, words) {
  await page.keyboard.press('Control+k');
  await page.keyboard.type(words);
  await page.keyboard.press('Enter');
}

/** A page of the help, with a timer at hand. @param {string} at @returns {State['reach']} */
const help = (at) => async (page) => {
  await connect(page);
  await goTo(page, `help/${at}`);
  await page.locator('.help-nav').waitFor();
};

/** A program in memory of the timer, of another class. @param {string} timerClass @returns {State['reach']} */
const simulated = (timerClass) => async (page) => {
  await press(page, `Try a simulated ${timerClass} timer`);
  await settled(page);
};

/** The pictures in README and docs: state, size and theme. A test compares this list with them. */
export const inDocs = [
  'changed-desktop-light',
  'start-phone-light',
  'changed-phone-sun',
  'range-desktop-light',
  'write-desktop-light',
  'verified-phone-light',
  'bench-desktop-light',
  'memories-desktop-dark',
  'interrupted-desktop-light',
  'line-desktop-dark',
];

/** The screenshots for browsers that offer to install the page, by their names in the manifest. */
export const inManifest = {
  'program-wide': 'changed-desktop-light',
  'write-wide': 'write-desktop-light',
  'program-narrow': 'changed-phone-light',
  'write-narrow': 'write-phone-light',
};

/** @type {Readonly<Record<string, State>>} */
export const states = {
  start: {
    title: 'Before anything is connected',
    reach: async (page) => {
      await page.getByRole('button', { name: 'Connect' }).first().waitFor();
    },
  },
  'new-program': {
    title: 'Making a program without a timer',
    reach: async (page) => {
      await press(page, 'New program…');
      await page.getByRole('dialog', { name: 'New program' }).waitFor();
    },
  },
  made: {
    title: 'A program that is in no timer yet',
    reach: async (page) => {
      await press(page, 'New program…');
      await press(page, 'Make the program');
      await enter(page, 'Function 4, S2', '70');
    },
  },
  program: {
    title: 'What the timer holds',
    reach: async (page) => {
      await connect(page);
      await toTop(page);
    },
  },
  changed: {
    title: 'Two values changed',
    reach: change,
  },
  field: {
    title: 'A field being edited',
    reach: async (page) => {
      await change(page);
      const field = page.getByRole('textbox', { name: 'Function 4, S2', exact: true });
      // A finger brings the keys of a phone.
      await ((await page.evaluate(() => navigator.maxTouchPoints > 0)) ? field.tap() : field.click());
    },
  },
  range: {
    title: 'A range, and what can be done with it',
    reach: async (page) => {
      await connect(page);
      await page.getByRole('textbox', { name: 'Function 2, S1', exact: true }).focus();
      for (const key of ['ArrowDown', 'ArrowDown', 'ArrowRight']) await page.keyboard.press(`Shift+${key}`);
      await page.getByRole('toolbar').getByText('3 functions, 2 columns').waitFor();
    },
  },
  checks: {
    title: 'Checks, with corrections',
    reach: async (page) => {
      await connect(page);
      await enter(page, 'Function 3 time', '10.5');
      await enter(page, 'Function 5, S1', '999');
      await enter(page, 'DT time', '0:50');
      await showPicture(page);
      await page.getByRole('heading', { name: 'Checks' }).scrollIntoViewIfNeeded();
    },
  },
  shift: {
    title: 'The tools of a row',
    reach: async (page) => {
      await connect(page);
      await press(page, 'Tools for Motor stop');
    },
  },
  paste: {
    title: 'A paste, before it is done',
    reach: async (page) => {
      await connect(page);
      await page.getByRole('textbox', { name: 'Function 2, S1', exact: true }).click();
      await page.evaluate(() => {
        const clipboardData = new DataTransfer();
        clipboardData.setData(
          'text/plain',
          'Function\tZeit\tS1\tS2\nF2\t11.5\t40\t41\nF9\t15\tup\t42\nF10\t16\t44\t45\nMotor stop\t9',
        );
        document.activeElement?.dispatchEvent(
          new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }),
        );
      });
      await page.getByRole('dialog').waitFor();
    },
  },
  write: {
    title: 'Before a write',
    reach: review,
  },
  verified: {
    title: 'After a write',
    reach: async (page) => {
      await review(page);
      await promise(page);
      await page
        .getByRole('dialog')
        .getByRole('button', { name: /^Write/ })
        .click();
      await page
        .getByRole('dialog')
        .getByText(/verified/i)
        .first()
        .waitFor();
    },
  },
  unkept: {
    title: 'Positions that were not kept, and the way to keep them',
    bench: { granted: true, quirks: { servoNeedsMove: true } },
    reach: async (page) => {
      await change(page, connectPort);
      await press(page, /^Write( \d+ changes?)?…$/);
      await promise(page);
      await page.getByRole('button', { name: 'Write 2 changes', exact: true }).click();
      await page.getByRole('button', { name: 'Write again…' }).click();
      await page.getByRole('checkbox', { name: /^Move the servos/ }).check();
    },
  },
  preview: {
    title: 'Flight preview',
    reach: async (page) => {
      await connect(page);
      await showPicture(page);
      await page.locator('.preview').scrollIntoViewIfNeeded();
    },
  },
  servos: {
    title: 'What the servos move',
    reach: async (page) => {
      await connect(page);
      await showPicture(page);
      await press(page, 'Name the servos…');
    },
  },
  bench: {
    title: 'The bench',
    reach: async (page) => {
      await connect(page);
      await goTo(page, 'bench');
      await promise(page);
      await press(page, /^Next$/);
      await page.getByRole('button', { name: 'Previous' }).first().waitFor();
    },
  },
  following: {
    title: 'Servos follow the positions',
    reach: follow,
  },
  tried: {
    title: 'What was tried: keep it or put it back',
    reach: async (page) => {
      await follow(page);
      await press(page, 'Stop following');
      await page.getByRole('button', { name: 'Keep it' }).first().waitFor();
      await settled(page);
    },
  },
  memories: {
    title: 'All memories',
    reach: readAll,
  },
  looked: {
    title: 'A memory that is looked at',
    reach: async (page) => {
      await readAll(page);
      await goTo(page, 'program');
      await lookAt(page, 'M3');
      await page.getByRole('heading', { name: /^M3, read / }).waitFor();
    },
  },
  apart: {
    title: 'M3 in the table, while M1 flies next',
    reach: async (page) => {
      await connect(page);
      await lookAt(page, 'M3');
      await press(page, 'Edit M3');
      await page.getByText('This is M3.').waitFor();
      await enter(page, 'DT time', '2:00');
      await toTop(page);
    },
  },
  disconnected: {
    title: 'Not connected, with changes',
    reach: async (page) => {
      await change(page);
      await disconnect(page);
      await page.getByText('2 changes').waitFor();
    },
  },
  known: {
    title: 'A known adapter, and the settings of its port',
    bench: { granted: true },
    reach: async (page) => {
      await page.getByRole('link', { name: 'Settings' }).click();
      await page.getByText('Serial settings').click();
    },
  },
  waiting: {
    title: 'Nothing answers yet',
    bench: { granted: true },
    reach: async (page) => {
      await page.evaluate(() => window.workbench.sleep());
      await press(page, 'Connect');
      await page.getByText(/^No answer for 1[0-9]\s/).waitFor();
    },
  },
  'waiting-help': {
    title: 'What to do while nothing answers',
    bench: { granted: true },
    reach: async (page) => {
      await page.evaluate(() => window.workbench.sleep());
      await press(page, 'Connect');
      await page.getByText(/^No answer for 1[0-9]\s/).waitFor();
      await page.getByText('What to do').click();
    },
  },
  refused: {
    title: 'The port does not open',
    bench: { granted: true },
    reach: async (page) => {
      await page.evaluate(() => window.workbench.setBusy(true));
      await press(page, 'Connect');
      await page.getByText('What to do').first().waitFor();
    },
  },
  disturbed: {
    title: 'A disturbed line',
    bench: { granted: true, damage: 0.1 },
    reach: async (page) => {
      await press(page, 'Connect');
      await page.getByText(/Answers are missing or damaged:/).waitFor();
    },
  },
  away: {
    title: 'The adapter is out',
    bench: { granted: true },
    reach: async (page) => {
      await change(page, connectPort);
      await page.evaluate(() => window.workbench.adapter.unplug());
      await page.locator('.notices').getByText('The connection to the adapter is lost.').waitFor();
    },
  },
  conflict: {
    title: 'The timer holds something else than was read',
    bench: { granted: true },
    reach: conflict,
  },
  uncertain: {
    title: 'A write was cut off: what the timer holds is not known',
    bench: { granted: true },
    reach: async (page) => {
      await change(page, connectPort);
      await press(page, /^Write( \d+ changes?)?…$/);
      await page.evaluate(() => window.workbench.unplugAt('SETTIMERS'));
      await promise(page);
      await page.getByRole('button', { name: 'Write 2 changes', exact: true }).click();
      await page.getByRole('alert').getByText('It is not certain what the timer holds.').waitFor();
      await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
      await toTop(page);
    },
  },
  interrupted: {
    title: 'A write was interrupted',
    bench: { granted: true },
    reach: async (page) => {
      await conflict(page);
      await page.evaluate(() => window.workbench.unplugAt('SETTIMERS'));
      await promise(page);
      await page.getByRole('button', { name: 'Write 2 changes', exact: true }).click();
      await page.getByRole('alert').getByText('It is not certain what the timer holds.').waitFor();
      await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
      await page.evaluate(() => window.workbench.replug());
      await settled(page);
      await page.locator('summary', { hasText: 'Compare' }).click();
      await toTop(page);
    },
  },
  shortDt: {
    title: 'Before Disconnect with a short DT',
    reach: async (page) => {
      await trim(page);
      await press(page, 'Close');
      // On a phone its button needs one more tap.
      await command(page, 'disconnect');
      await page.getByRole('dialog', { name: 'Before you disconnect' }).waitFor();
    },
  },
  flight: {
    title: 'A flight is filled in',
    reach: async (page) => {
      await trim(page);
      await press(page, 'Flying this');
      await press(page, 'Fill in');
      const form = page.getByRole('dialog', { name: 'Flight' });
      await form.getByRole('textbox', { name: 'Result' }).fill('0:19,5');
      await form.getByRole('button', { name: '2', exact: true }).click();
      await press(page, 'Wind: more');
      await press(page, 'Temperature: more');
    },
  },
  flights: {
    title: 'The log of flights',
    reach: async (page) => {
      await trim(page);
      await press(page, 'Flying this');
      await press(page, 'Close');
      await goTo(page, 'library/flights');
      await press(page, 'Flying this');
      await press(page, 'Fill in');
      const form = page.getByRole('dialog', { name: 'Flight' });
      await form.getByRole('textbox', { name: 'Result' }).fill('178');
      await form.getByRole('textbox', { name: 'Note' }).fill('Good air over the wood');
      await press(page, 'Done');
    },
  },
  scoreCard: {
    title: 'The score card of a day',
    reach: async (page) => {
      await connect(page);
      await goTo(page, 'library/flights');
      for (const flown of ['1 4:00', '2 2:31', '2 2:58,5', '3 ', 'Fly-off 5:12']) {
        const [round = '', result = ''] = flown.split(' ');
        await press(page, 'Flying this');
        await press(page, 'Fill in');
        const form = page.getByRole('dialog', { name: 'Flight' });
        await form.getByRole('textbox', { name: 'Result' }).fill(result);
        await form.getByRole('button', { name: round, exact: true }).click();
        await form.getByRole('button', { name: 'Done' }).click();
      }
      await press(page, 'Score card');
      await enter(page, 'Maximum of each round', '3:00');
      await enter(page, 'Maximum of Round 1', '4:00');
    },
  },
  print: {
    title: 'The sheet of what is on the screen',
    reach: async (page) => {
      await connect(page);
      await goTo(page, 'print');
      await page.locator('.leaf').waitFor();
    },
  },
  share: {
    title: 'A setting as a link and a QR code',
    reach: async (page) => {
      await connect(page);
      await offer(page);
    },
  },
  received: {
    title: 'A setting that came by link',
    reach: async (page) => {
      await connect(page);
      await offer(page);
      const link = await page.getByRole('textbox', { name: 'Link', exact: true }).inputValue();
      await press(page, 'Close');
      await page.evaluate((hash) => location.assign(hash), new URL(link).hash);
      await page.getByRole('dialog', { name: 'A program from a link' }).waitFor();
    },
  },
  'empty-library': {
    title: 'A library with nothing in it',
    reach: async (page) => {
      await goTo(page, 'library');
      await page.getByRole('button', { name: 'Import…' }).waitFor();
    },
  },
  import: {
    title: 'What a file would bring',
    reach: async (page) => {
      await fill(page);
      await drop(
        page,
        example.replaceAll('"calm morning"', '"windy morning"').replaceAll('2026-11-18T', '2026-11-24T'),
      );
      await page.getByText('Newer in the file').waitFor();
    },
  },
  imported: {
    title: 'What a file has brought',
    reach: (page) => take(page),
  },
  'import-refused': {
    title: 'A file that cannot be read',
    reach: async (page) => {
      await drop(page, example.replace('"10.50"', '"1050"'));
      await page.getByRole('alert').first().waitFor();
    },
  },
  exported: {
    title: 'The library was saved to a file',
    reach: async (page) => {
      await fill(page);
      await press(page, 'Export all…');
      await page.getByText(/goes to your downloads/).waitFor();
    },
  },
  model: {
    title: 'A model and its settings',
    reach: async (page) => {
      await fill(page);
      await page
        .getByRole('link', { name: /^Lancer 07/ })
        .first()
        .click();
      await page.getByRole('heading', { name: 'Lancer 07' }).waitFor();
    },
  },
  setting: {
    title: 'A setting',
    reach: async (page) => {
      await fill(page);
      await goTo(page, 'library/lancer-07/calm-morning');
      await page.getByRole('article', { name: 'calm morning' }).waitFor();
    },
  },
  line: {
    title: 'What went over the line',
    bench: { granted: true },
    reach: async (page) => {
      await page.evaluate(() => window.workbench.damageAfter(20));
      await connectPort(page);
      await goTo(page, 'line');
    },
  },
  frame: {
    title: 'A frame by hand, asked twice',
    bench: { granted: true },
    reach: async (page) => {
      await connectPort(page);
      await goTo(page, 'line');
      await page.getByText('Send a frame by hand').click();
      await page.getByLabel('Letter and data, in hex').fill('6D');
      await press(page, 'Send…');
    },
  },
  recording: {
    title: 'A recording of a line',
    bench: { granted: true },
    reach: async (page) => {
      await connectPort(page);
      await goTo(page, 'line');
      const text = `# Sidus capture 1\n0.000 > 00 00 00 00 00 03 6b 6b 45\n9.000 < ${'ff '.repeat(200)}`;
      const file = { name: 'field.txt', mimeType: 'text/plain', buffer: Buffer.from(text) };
      const choosing = page.waitForEvent('filechooser');
      await press(page, 'Load…');
      await (await choosing).setFiles(file);
      await page.getByRole('button', { name: 'Back to the live line' }).waitFor();
    },
  },
  figures: {
    title: 'What has no room in the strip of a phone',
    bench: { granted: true },
    reach: async (page) => {
      await connectPort(page);
      await showFigures(page);
    },
  },
  'class-b': {
    title: 'A timer of class B',
    reach: simulated('F1B'),
  },
  'class-e': {
    title: 'A timer of class E',
    reach: simulated('F1E'),
  },
  largest: {
    title: 'The largest program that there is',
    reach: async (page) => {
      await press(page, 'New program…');
      await page.getByRole('combobox', { name: 'Functions, without start and DT' }).selectOption('20');
      await page.getByRole('combobox', { name: 'Servos' }).selectOption('8');
      await press(page, 'Make the program');
      await page.getByRole('textbox', { name: 'Function 4 time' }).waitFor();
    },
  },
  commands: {
    title: 'The list of commands',
    reach: async (page) => {
      await change(page);
      await page.keyboard.press('Control+k');
      await page.getByRole('dialog').getByRole('option').first().waitFor();
    },
  },
  copy: {
    title: 'Before a memory is copied',
    reach: async (page) => {
      await connect(page);
      await goTo(page, 'memories');
      await page.getByLabel('Copy to…: M1', { exact: true }).click();
      await press(page, /^Copy M1 to M/);
      await page.getByRole('dialog').getByRole('checkbox').first().waitFor();
    },
  },
  'model-choice': {
    title: 'Which model is connected',
    reach: async (page) => {
      await fill(page);
      await goTo(page, 'program');
      await connect(page);
      if (!(await page.locator('.memories').isVisible())) await showFigures(page);
      await press(page, /model it is$|^Which model/);
      await page.getByRole('dialog').waitFor();
    },
  },
  save: {
    title: 'A program is saved as a setting',
    reach: async (page) => {
      await connect(page);
      await command(page, 'save');
      await page.getByRole('dialog').waitFor();
    },
  },
  'new-model': {
    title: 'A new model',
    reach: async (page) => {
      await goTo(page, 'library');
      await press(page, 'New model…');
      await page.getByRole('dialog').waitFor();
    },
  },
  pair: {
    title: 'Two programs side by side',
    reach: async (page) => {
      await connect(page);
      await enter(page, 'Function 4, S2', '77');
      await goTo(page, 'library/compare');
      await page.getByRole('table').first().waitFor();
    },
  },
  settings: {
    title: 'The settings, with a timer connected',
    reach: async (page) => {
      await connect(page);
      await goTo(page, 'settings');
      await page.getByText('About this timer').click();
    },
  },
  settle: {
    title: 'A walk through what is open about a timer, at a position to try',
    reach: async (page) => {
      await connect(page);
      await goTo(page, 'settings/settle');
      await promise(page);
      await press(page, 'Read the timer');
      // The strip has a memory that flies next.
      for (let i = 0; i < 4; i++) await page.locator('.settle-step').getByRole('button', { name: 'Next' }).click();
      await press(page, 'Move the servos to DT');
      await settled(page);
    },
  },
  erase: {
    title: 'Before all data is deleted',
    reach: async (page) => {
      await fill(page);
      await goTo(page, 'settings');
      await press(page, /^Delete/);
      await page.getByRole('dialog').waitFor();
    },
  },
  checklist: { title: 'The checklist', reach: help('checklist') },
  trouble: { title: 'What to do in trouble', reach: help('trouble') },
  words: { title: 'The words of the field', reach: help('words') },
  steps: { title: 'The first steps', reach: help('steps') },
};
