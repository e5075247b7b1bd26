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

/** Opens the difference. @param {Page} page */
async function review(page) {
  await press(page, /^Write( \d+ changes?)?…$/);
  await page.getByRole('dialog').waitFor();
}

/** Begins to write, from the difference on. @param {Page} page */
async function write(page) {
  await promise(page);
  await press(page, /^Write \d+ changes?$/);
}

/** A DT for trimming is written. @param {Page} page */
async function trim(page) {
  await connect(page);
  await enter(page, 'DT time', '20 s');
  await review(page);
  await write(page);
  await page.getByText('Verified.').waitFor();
}

/** The plug is pulled before the answer to a write. @param {Page} page */
async function cutOff(page) {
  await page.evaluate(() => window.workbench.unplugAt('SETTIMERS'));
  await write(page);
  await page.getByRole('alert').getByText('It is not certain what the timer holds.').waitFor();
  await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
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
  await review(page);
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

/** With the simulated timer of the page. @param {string} title @param {State['reach']} reach @returns {State} */
const state = (title, reach) => ({ title, reach });

/**
 * With a workbench.
 * @param {string} title @param {State['reach']} reach @param {State['bench']} [more]
 * @returns {State}
 */
const atBench = (title, reach, more) => ({ title, reach, bench: { granted: true, ...more } });

/** @type {Readonly<Record<string, State>>} */
export const states = {
  start: state('Before anything is connected', async (page) => {
    await page.getByRole('button', { name: 'Connect' }).first().waitFor();
  }),
  'new-program': state('Making a program without a timer', async (page) => {
    await press(page, 'New program…');
    await page.getByRole('dialog', { name: 'New program' }).waitFor();
  }),
  made: state('A program that is in no timer yet', async (page) => {
    await press(page, 'New program…');
    await press(page, 'Make the program');
    await enter(page, 'Function 4, S2', '70');
  }),
  program: state('What the timer holds', async (page) => {
    await connect(page);
    await toTop(page);
  }),
  changed: state('Two values changed', change),
  field: state('A field being edited', async (page) => {
    await change(page);
    const field = page.getByRole('textbox', { name: 'Function 4, S2', exact: true });
    // A finger brings the keys of a phone.
    await ((await page.evaluate(() => navigator.maxTouchPoints > 0)) ? field.tap() : field.click());
  }),
  range: state('A range, and what can be done with it', async (page) => {
    await connect(page);
    await page.getByRole('textbox', { name: 'Function 2, S1', exact: true }).focus();
    for (const key of ['ArrowDown', 'ArrowDown', 'ArrowRight']) await page.keyboard.press(`Shift+${key}`);
    await page.getByRole('toolbar').getByText('3 functions, 2 columns').waitFor();
  }),
  errors: state('The longest values, and one that no timer can hold', async (page) => {
    await connect(page);
    await enter(page, 'Motor stop time', '39.95');
    await enter(page, 'Function 1 time', '1:30.25');
    await enter(page, 'DT time', '10:00');
    await enter(page, 'Function 2, S1', '130');
    await enter(page, 'Idle throttle', 'x');
    await toTop(page);
  }),
  checks: state('Checks, with corrections', async (page) => {
    await connect(page);
    await enter(page, 'Function 3 time', '10.5');
    await enter(page, 'Function 5, S1', '999');
    await enter(page, 'DT time', '0:50');
    await showPicture(page);
    await page.getByRole('heading', { name: 'Checks' }).scrollIntoViewIfNeeded();
  }),
  shift: state('The tools of a row', async (page) => {
    await connect(page);
    await press(page, 'Tools for Motor stop');
  }),
  paste: state('A paste, before it is done', async (page) => {
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
  }),
  write: state('Before a write', async (page) => {
    await change(page);
    await review(page);
  }),
  verified: state('After a write', async (page) => {
    await change(page);
    await review(page);
    await write(page);
    await page.getByText('Verified.').waitFor();
  }),
  unkept: atBench(
    'Positions that were not kept, and the way to keep them',
    async (page) => {
      await change(page, connectPort);
      await review(page);
      await write(page);
      await page.getByRole('button', { name: 'Write again…' }).click();
      await page.getByRole('checkbox', { name: /^Move the servos/ }).check();
    },
    { quirks: { servoNeedsMove: true } },
  ),
  preview: state('Flight preview', async (page) => {
    await connect(page);
    await showPicture(page);
    await page.locator('.preview').scrollIntoViewIfNeeded();
  }),
  servos: state('What the servos move', async (page) => {
    await connect(page);
    await showPicture(page);
    await press(page, 'Name the servos…');
  }),
  bench: state('The bench', async (page) => {
    await connect(page);
    await goTo(page, 'bench');
    await promise(page);
    await press(page, /^Next$/);
    await page.getByRole('button', { name: 'Previous' }).first().waitFor();
  }),
  following: state('Servos follow the positions', follow),
  tried: state('What was tried: keep it or put it back', async (page) => {
    await follow(page);
    await press(page, 'Stop following');
    await page.getByRole('button', { name: 'Keep it' }).first().waitFor();
    await settled(page);
  }),
  memories: state('All memories', readAll),
  looked: state('A memory that is looked at', async (page) => {
    await readAll(page);
    await goTo(page, 'program');
    await lookAt(page, 'M3');
    await page.getByRole('heading', { name: /^M3, read / }).waitFor();
  }),
  apart: state('M3 in the table, while M1 flies next', async (page) => {
    await connect(page);
    await lookAt(page, 'M3');
    await press(page, 'Edit M3');
    await page.getByText('This is M3.').waitFor();
    await enter(page, 'DT time', '2:00');
    await toTop(page);
  }),
  disconnected: state('Not connected, with changes', async (page) => {
    await change(page);
    await disconnect(page);
    await page.getByText('2 changes').waitFor();
  }),
  known: atBench('A known adapter, and the settings of its port', async (page) => {
    await page.getByRole('link', { name: 'Settings' }).click();
    await page.getByText('Serial settings').click();
  }),
  waiting: atBench('Nothing answers yet, and what to do', async (page) => {
    await page.evaluate(() => window.workbench.sleep());
    await press(page, 'Connect');
    await page.getByText(/^No answer for 1[0-9]\s/).waitFor();
    await page.getByText('What to do').click();
  }),
  refused: atBench('The port does not open', async (page) => {
    await page.evaluate(() => window.workbench.setBusy(true));
    await press(page, 'Connect');
    await page.getByText('What to do').first().waitFor();
  }),
  disturbed: atBench(
    'A disturbed line',
    async (page) => {
      await press(page, 'Connect');
      await page.getByText(/Answers are missing or damaged:/).waitFor();
    },
    { damage: 0.1 },
  ),
  away: atBench('The adapter is out', async (page) => {
    await change(page, connectPort);
    await page.evaluate(() => window.workbench.adapter.unplug());
    await page.locator('.notices').getByText('The connection to the adapter is lost.').waitFor();
  }),
  conflict: atBench('The timer holds something else than was read', conflict),
  uncertain: atBench('A write was cut off: what the timer holds is not known', async (page) => {
    await change(page, connectPort);
    await review(page);
    await cutOff(page);
    await toTop(page);
  }),
  interrupted: atBench('A write was interrupted', async (page) => {
    await conflict(page);
    await cutOff(page);
    await page.evaluate(() => window.workbench.replug());
    await settled(page);
    await page.locator('summary', { hasText: 'Compare' }).click();
    await toTop(page);
  }),
  shortDt: state('Before Disconnect with a short DT', async (page) => {
    await trim(page);
    await press(page, 'Close');
    // On a phone its button needs one more tap.
    await command(page, 'disconnect');
    await page.getByRole('dialog', { name: 'Before you disconnect' }).waitFor();
  }),
  flight: state('A flight is filled in', async (page) => {
    await trim(page);
    await press(page, 'Flying this');
    await press(page, 'Fill in');
    const form = page.getByRole('dialog', { name: 'Flight' });
    await form.getByRole('textbox', { name: 'Result' }).fill('0:19,5');
    await form.getByRole('button', { name: '2', exact: true }).click();
    await press(page, 'Wind: more');
    await press(page, 'Temperature: more');
  }),
  flights: state('The log of flights', async (page) => {
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
  }),
  scoreCard: state('The score card of a day', async (page) => {
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
  }),
  print: state('The sheet of what is on the screen', async (page) => {
    await connect(page);
    await goTo(page, 'print');
    await page.locator('.leaf').waitFor();
  }),
  share: state('A setting as a link and a QR code', async (page) => {
    await connect(page);
    await offer(page);
  }),
  received: state('A setting that came by link', async (page) => {
    await connect(page);
    await offer(page);
    const link = await page.getByRole('textbox', { name: 'Link', exact: true }).inputValue();
    await press(page, 'Close');
    await page.evaluate((hash) => location.assign(hash), new URL(link).hash);
    await page.getByRole('dialog', { name: 'A program from a link' }).waitFor();
  }),
  'empty-library': state('A library with nothing in it', async (page) => {
    await goTo(page, 'library');
    await page.getByRole('button', { name: 'Import…' }).waitFor();
  }),
  import: state('What a file would bring', async (page) => {
    await fill(page);
    await drop(page, example.replaceAll('"calm morning"', '"windy morning"').replaceAll('2026-11-18T', '2026-11-24T'));
    await page.getByText('Newer in the file').waitFor();
  }),
  imported: state('What a file has brought', (page) => take(page)),
  'import-refused': state('A file that cannot be read', async (page) => {
    await drop(page, example.replace('"10.50"', '"1050"'));
    await page.getByRole('alert').first().waitFor();
  }),
  exported: state('The library was saved to a file', async (page) => {
    await fill(page);
    await press(page, 'Export all…');
    await page.getByText(/goes to your downloads/).waitFor();
  }),
  model: state('A model and its settings', async (page) => {
    await fill(page);
    await page
      .getByRole('link', { name: /^Lancer 07/ })
      .first()
      .click();
    await page.getByRole('heading', { name: 'Lancer 07' }).waitFor();
  }),
  setting: state('A setting', async (page) => {
    await fill(page);
    await goTo(page, 'library/lancer-07/calm-morning');
    await page.getByRole('article', { name: 'calm morning' }).waitFor();
  }),
  line: atBench('What went over the line', async (page) => {
    await page.evaluate(() => window.workbench.damageAfter(20));
    await connectPort(page);
    await goTo(page, 'line');
  }),
  frame: atBench('A frame by hand, asked twice', async (page) => {
    await connectPort(page);
    await goTo(page, 'line');
    await page.getByText('Send a frame by hand').click();
    await page.getByLabel('Letter and data, in hex').fill('6D');
    await press(page, 'Send…');
  }),
  recording: atBench('A recording of a line', async (page) => {
    await connectPort(page);
    await goTo(page, 'line');
    const text = `# Sidus capture 1\n0.000 > 00 00 00 00 00 03 6b 6b 45\n9.000 < ${'ff '.repeat(200)}`;
    const file = { name: 'field.txt', mimeType: 'text/plain', buffer: Buffer.from(text) };
    const choosing = page.waitForEvent('filechooser');
    await press(page, 'Load…');
    await (await choosing).setFiles(file);
    await page.getByRole('button', { name: 'Back to the live line' }).waitFor();
  }),
  figures: atBench('What has no room in the strip of a phone', async (page) => {
    await connectPort(page);
    await showFigures(page);
  }),
  'class-b': state('A timer of class B', simulated('F1B')),
  'class-e': state('A timer of class E', simulated('F1E')),
  largest: state('The largest program that there is', async (page) => {
    await press(page, 'New program…');
    await page.getByRole('combobox', { name: 'Functions, without start and DT' }).selectOption('20');
    await page.getByRole('combobox', { name: 'Servos' }).selectOption('8');
    await press(page, 'Make the program');
    await page.getByRole('textbox', { name: 'Function 4 time' }).waitFor();
  }),
  commands: state('The list of commands', async (page) => {
    await change(page);
    await page.keyboard.press('Control+k');
    await page.getByRole('dialog').getByRole('option').first().waitFor();
  }),
  copy: state('Before a memory is copied', async (page) => {
    await connect(page);
    await goTo(page, 'memories');
    await page.getByLabel('Copy to…: M1', { exact: true }).click();
    await press(page, /^Copy M1 to M/);
    await page.getByRole('dialog').getByRole('checkbox').first().waitFor();
  }),
  'model-choice': state('Which model is connected', async (page) => {
    await fill(page);
    await goTo(page, 'program');
    await connect(page);
    if (!(await page.locator('.memories').isVisible())) await showFigures(page);
    await press(page, /model it is$|^Which model/);
    await page.getByRole('dialog').waitFor();
  }),
  save: state('A program is saved as a setting', async (page) => {
    await connect(page);
    await command(page, 'save');
    await page.getByRole('dialog').waitFor();
  }),
  'new-model': state('A new model', async (page) => {
    await goTo(page, 'library');
    await press(page, 'New model…');
    await page.getByRole('dialog').waitFor();
  }),
  pair: state('Two programs side by side', async (page) => {
    await connect(page);
    await enter(page, 'Function 4, S2', '77');
    await goTo(page, 'library/compare');
    await page.getByRole('table').first().waitFor();
  }),
  settings: state('The settings, with a timer connected', async (page) => {
    await connect(page);
    await goTo(page, 'settings');
    await page.getByText('About this timer').click();
  }),
  settle: state('A walk through what is open about a timer, at a position to try', async (page) => {
    await connect(page);
    await goTo(page, 'settings/settle');
    await promise(page);
    await press(page, 'Read the timer');
    // The strip has a memory that flies next.
    for (let i = 0; i < 4; i++) await page.locator('.settle-step').getByRole('button', { name: 'Next' }).click();
    await press(page, 'Move the servos to DT');
    await settled(page);
  }),
  erase: state('Before all data is deleted', async (page) => {
    await fill(page);
    await goTo(page, 'settings');
    await press(page, /^Delete/);
    await page.getByRole('dialog').waitFor();
  }),
  checklist: state('The checklist', help('checklist')),
  trouble: state('What to do in trouble', help('trouble')),
  words: state('The words of the field', help('words')),
  steps: state('The first steps', help('steps')),
};
