import { expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { comparingMessages } from '../../src/app/messages/en-compare.js';
import { exampleMemories } from '../../src/simulator/index.js';
import { AppPage } from './app-page.js';

const IDENTITY = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };
const THEN = new Date(2025, 10, 12, 14, 32).getTime();

/** What the four memories of a model hold. Model 0 holds what a simulated timer holds. */
function memoriesOf(model: number) {
  return exampleMemories('Q').map(({ times, positions }, memory) => ({
    program: {
      identity: IDENTITY,
      memory,
      times: times.map((time, slot) => time + (slot > 0 && slot < 10 ? (model % 7) * 5 : 0)),
      positions: positions.map((row, servo) =>
        row.map((position, slot) =>
          Math.max(0, Math.min(130, position + (model === 0 ? 0 : 1 + ((model * (slot + 3) + servo * model) % 31)))),
        ),
      ),
      idleThrottle: 30,
    },
    at: THEN,
  }));
}

function record(key: string, name: string, model: number, simulated = true) {
  const verified = memoriesOf(model).map((held) => (simulated ? { ...held, simulated } : held));
  const about = { timerClass: 'Q', note: '', servos: [], memoryNames: ['calm'], archived: false };
  return { key, order: model, changedAt: THEN, verified, model: { id: key, name, ...about } };
}

/** 300 models of simulated timers, and one of a real timer with the same content as the wanted one. */
const MODELS = [
  record('twin', 'Real twin', 0, false),
  ...Array.from({ length: 299 }, (_, at) => record(`m${at + 1}`, `Model ${at + 1}`, at + 1)),
  record('lancer', 'Lancer 07', 0),
];

/** Puts them into the storage of the page. */
async function keep(app: AppPage, models: readonly object[]): Promise<void> {
  await app.page.evaluate(async (records) => {
    const opened = await new Promise<IDBDatabase>((resolve, reject) => {
      const asked = indexedDB.open('sidus-timer');
      asked.onsuccess = () => resolve(asked.result);
      asked.onerror = () => reject(asked.error);
    });
    const change = opened.transaction('models', 'readwrite');
    for (const each of records) change.objectStore('models').put(each);
    await new Promise((resolve) => change.addEventListener('complete', resolve));
    opened.close();
  }, models);
  await app.page.reload();
}

test('the right one of 300 models is found by what its timer holds, and gets the backup', async () => {
  const app = await AppPage.open();
  await app.button('Try a simulated F1Q timer').waitFor();
  await keep(app, MODELS);
  await app.trySimulated('F1Q');
  await app.text('This is Lancer 07, as seen 12 Nov 2025.').waitFor();
  await app.button('OK').click();
  await app.button('Model Lancer 07: say which model it is').waitFor();

  await app.type('DT time', '5:00');
  await app.review();
  await app.text('This is what changes in M1 “calm” of Lancer 07. Everything else stays as it is.').waitFor();
  await app.tickSafety();
  await app.dialog.getByRole('button', { name: 'Write 1 change' }).click();
  await app.result('Verified.');
  await app.close();
  await app.page.evaluate(() => location.assign('#library/lancer'));
  const { differs, now } = comparingMessages.modelBackups;
  await app.text(differs(1, now)).waitFor();
});

test('two programs are shown side by side, and one value is copied', async () => {
  const app = await AppPage.open();
  await app.trySimulated('F1Q');
  await app.type('Function 4, S2', '77');
  await app.page.evaluate(() => location.assign('#library/compare'));
  const choice = (name: string) => app.page.getByRole('combobox', { name, exact: true });
  await choice('Compare').waitFor();
  await expect.poll(() => choice('with').locator('option:checked').textContent()).toBe('Timer, M1');
  await app.text('1 value differs.').waitFor();
  await choice('Compare').selectOption({ label: 'Timer, M1' });
  await expect.poll(() => choice('Compare').locator('option:checked').textContent()).toBe('Timer, M1');
  await expect
    .poll(() => choice('with').locator('option:checked').textContent())
    .toBe(comparingMessages.compare.screen);
  await app.button('Take 52 for function 4, S2').click();
  await app.text(en.overview.same).waitFor();
  await app.goTo('Program');
  await expect.poll(() => app.valueOf('Function 4, S2')).toBe('52');
});
