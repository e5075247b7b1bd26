import { expect, test } from 'vitest';
import { exampleMemories } from '../../src/simulator/index.js';
import { AppPage, edgesOf, hiddenOf } from './app-page.js';
import { fillLibrary } from './library.js';
import { IN_SUN, PHONE } from './page.js';

const IDENTITY = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };
const NAME = 'Wettbewerbsflieger Großenkneten 07';
const MEMORY = 'Morgenthermik bei schwachem Wind';

/** A model whose timer held what the simulated one holds. */
function modelOf(key: string, name: string) {
  const verified = exampleMemories('Q').map(({ times, positions }, memory) => ({
    program: { identity: IDENTITY, memory, times, positions, idleThrottle: 30 },
    at: 0,
    simulated: true,
  }));
  const model = {
    id: key,
    name,
    timerClass: 'Q',
    note: '',
    servos: [],
    memoryNames: [MEMORY],
    archived: false,
  };
  return { key, order: 1, changedAt: 0, verified, model };
}

test('long names of models and memories leave room for what they name, on a small phone in the sun', async () => {
  const app = await AppPage.open({ ...PHONE, viewport: { width: 360, height: 740 }, before: IN_SUN });
  await fillLibrary(app, { models: [modelOf('a', NAME), modelOf('b', `${NAME} neu`)], settings: [], flights: [] });
  await app.page.reload();
  await app.trySimulated('F1Q');
  const line = app.page.locator('.model-line');
  const cut = await line
    .locator('button')
    .evaluateAll((all) => all.filter((each) => each.scrollWidth > each.clientWidth).map((each) => each.textContent));
  expect(cut, 'the two names differ at their ends').toEqual([]);
  await line.getByRole('button', { name: `${NAME} neu` }).click();
  const { height } = await edgesOf(app.page.locator('.strip-line'));
  expect(height, 'the strip has two lines at most').toBeLessThan(100);

  await app.readAll();
  await app.button('Compare with M1: M2').click();
  const grid = app.page.locator('.program-grid');
  await grid.getByText(MEMORY).first().waitFor();
  expect(await hiddenOf(grid)).toBe(0);
  await app.expectNoSidewaysScrolling();
});

test('on a desktop the question which model it is stands above long names, not squeezed beside them', async () => {
  const app = await AppPage.open({ viewport: { width: 1280, height: 800 } });
  await fillLibrary(app, {
    models: [`${NAME} neu`, `${NAME} neu II`, 'Lancer 09'].map((name, at) => modelOf(`model-${at}`, name)),
    settings: [],
    flights: [],
  });
  await app.page.reload();
  await app.trySimulated('F1Q');
  const line = app.page.locator('.model-line');
  await line.waitFor();
  const { left, height } = await edgesOf(line);
  expect(height).toBeLessThan(120);
  expect(left, 'it begins where the strip begins').toBe((await edgesOf(app.page.locator('.strip .brand'))).left);
});
