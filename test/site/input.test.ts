import { describe, expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { AppPage } from './app-page.js';

/** Whether the middle of an element is visible and not covered. */
function isInSight(element: Element): boolean {
  const { left, top, width, height } = element.getBoundingClientRect();
  return document.elementFromPoint(left + width / 2, top + height / 2) === element;
}

/** How many requests the timer got since the page was loaded. */
const answered = (app: AppPage): Promise<number> => app.bench(({ adapter }) => adapter.timer.core.answered.length);

describe('what no timer can hold is refused at the field', () => {
  const cases: [field: string, text: string, shown: string, reason: string][] = [
    ['Function 2, S1', '131', '131', en.findings['position-out-of-range']({ min: '0', max: '130' })],
    [
      'DT time',
      '655.36',
      '10:55.36',
      en.findings['time-out-of-range']({ min: '0.00\u00a0s', max: '10:55.35\u00a0min' }),
    ],
    ['Function 2, S1', 'six', 'six', en.unreadable['not-a-whole-number']],
    ['DT time', 'soon', 'soon', en.unreadable['not-a-time']],
    ['Function 2, S1', '', '', en.unreadable.empty],
    ['DT time', '', '', en.unreadable.empty],
  ];

  test('with its reason, also through a reload, and Write leads there', async () => {
    const app = await AppPage.open({ bench: {} });
    await app.connect();
    for (const [field, text, shown, reason] of cases) {
      const what = `${field} = ${JSON.stringify(text)}`;
      const name = field === 'DT time' ? 'DT' : field;
      const asked = await answered(app);
      await app.type(field, text);
      await expect.poll(() => app.valueOf(field), { message: what }).toBe(shown);
      await expect.poll(() => app.field(field).getAttribute('aria-invalid'), { message: what }).toBe('true');
      await expect.poll(() => app.reasons(), { message: what }).toContain(`${name}: ${reason}`);
      await app.button(/^Write( \d+ changes?)?…$/).click();
      const cause = app.field(field);
      await expect
        .poll(() => cause.evaluate((input) => input === document.activeElement), { message: `Write leads to ${what}` })
        .toBe(true);
      await expect.poll(() => cause.evaluate(isInSight), { message: `Write brings ${what} into sight` }).toBe(true);

      await app.kept();
      expect(await answered(app), 'nothing was sent to the timer').toBe(asked);
      await app.reload();
      await expect.poll(() => app.valueOf(field), { message: what }).toBe(shown);
      await app.button('Connect').click();
      await app.isReady();
      await expect.poll(() => app.valueOf(field), { message: what }).toBe(shown);
      await app.text(`Nothing can be written yet. ${name}: ${reason}`).waitFor();
      await app.button('Undo all').click();
      await app.text('Nothing can be written yet.').waitFor({ state: 'hidden' });
    }
  });

  test('a text without an end: the page stays whole', async () => {
    const app = await AppPage.open({ bench: {} });
    await app.connect();
    await app.type('Function 2, S1', '9'.repeat(100_000));
    await app.type('DT time', '<img src=x onerror=alert(1)>'.repeat(100));
    await expect.poll(() => app.reasons()).toHaveLength(2);
    await app.expectNoSidewaysScrolling();
  });
});

describe('what was typed is kept', () => {
  test('through a reload, before anything is connected, and on top of what the timer holds then', async () => {
    const app = await AppPage.open({ bench: {} });
    await app.connect();
    await app.type('Function 2, S1', '7');
    await app.type('DT time', '4:00');
    await app.kept();
    await app.reload();
    await app.says(en.notes.back.title);
    await expect
      .poll(async () => [await app.valueOf('Function 2, S1'), await app.valueOf('DT time')])
      .toEqual(['7', '4:00']);
    await app.button('Connect').click();
    await app.isReady();
    await app.changes(2).waitFor();
    await app.write();
    await app.result('Verified.');
    await app.close();
    await app.kept();
    await app.reload();
    await app.kept();
    await expect
      .poll(() => app.text(en.notes.back.title).count(), { message: 'nothing is left to bring back' })
      .toBe(0);
  });

  test('when another memory is selected, text for text, and through a reload', async () => {
    const app = await AppPage.open({ bench: {} });
    await app.connect();
    await app.type('Function 2, S1', 'seven');
    await app.fly('M2');
    await expect.poll(() => app.valueOf('Function 2, S1')).toBe('35');
    await app.reload();
    await app.button('Connect').click();
    await app.isReady();
    await expect.poll(() => app.valueOf('Function 2, S1'), { message: 'M2 is still current' }).toBe('35');
    await app.fly('M1');
    await expect.poll(() => app.valueOf('Function 2, S1')).toBe('seven');
  });

  test('when its tab is closed, for the next tab', async () => {
    const app = await AppPage.open({ bench: {} });
    await app.connect();
    await app.type('Function 2, S1', '7');
    await app.kept();
    const other = await app.waitingTab();
    await other.button(en.otherTab.takeOver).waitFor();
    // The browser cannot remove the tab before that has ended, and until then it counts as open.
    await app.page.evaluate(() => {
      setTimeout(() => {
        const end = performance.now() + 5000;
        while (performance.now() < end);
      });
    });
    await app.page.close();
    await other.says(en.notes.back.title);
    await expect.poll(() => other.valueOf('Function 2, S1')).toBe('7');
  });
});

test('Enter and the arrows first end the composing of a text, and go to another cell only then', async () => {
  const app = await AppPage.open({ bench: {} });
  await app.connect();
  const devTools = await app.page.context().newCDPSession(app.page);
  const press = async (key: string, windowsVirtualKeyCode: number): Promise<void> => {
    for (const type of ['keyDown', 'keyUp'] as const)
      await devTools.send('Input.dispatchKeyEvent', { type, key, code: key, windowsVirtualKeyCode });
  };
  const focused = () => app.page.evaluate(() => document.activeElement?.ariaLabel);
  const place = 'Function 2, S1';
  await app.field(place).focus();
  await devTools.send('Input.imeSetComposition', { text: '12', selectionStart: 2, selectionEnd: 2 });
  for (const key of ['ArrowDown', 'Enter']) {
    await press(key, 229);
    expect([key, await focused(), await app.valueOf(place)]).toEqual([key, place, '12']);
  }
  await devTools.send('Input.insertText', { text: '127' });
  expect([await focused(), await app.valueOf(place)]).toEqual([place, '127']);
  await press('Enter', 13);
  expect(await focused()).toBe('Function 3, S1');
});

describe('the page starts all the same', () => {
  const program = (functions: number, servos: number, value: unknown) => ({
    identity: { timerClass: 'Q', firmware: '536', functions, memories: 4, servos },
    memory: 0,
    times: Array(functions + 1).fill(value),
    positions: Array(servos).fill(Array(functions + 1).fill(value)),
    idleThrottle: null,
  });
  const draft = {
    key: 'a',
    baseline: program(3, 1, 0),
    working: program(3, 1, 5),
    texts: {},
    savedAt: 1,
    simulated: false,
  };
  const garbage: [name: string, stored: object][] = [
    ['nothing of a draft but its key', { key: 'a' }],
    ['lists of another length than the identity says', { ...draft, working: { ...draft.working, times: [1] } }],
    ['texts for numbers', { ...draft, working: program(3, 1, 'five') }],
    ['numbers that are none', { ...draft, working: program(3, 1, Number.NaN) }],
    ['numbers that no timer holds', { ...draft, working: program(3, 1, -1e300) }],
    ['an identity of a thousand servos', { ...draft, working: program(3, 1000, 1) }],
    ['two programs of different timers', { ...draft, working: program(5, 2, 1) }],
    ['texts for fields that there are not', { ...draft, texts: { 'time:99': 'x', __proto__: 'y' } }],
  ];

  test('whatever was stored', async () => {
    const app = await AppPage.open({ bench: {} });
    await app.button('Connect').waitFor();
    for (const [what, stored] of garbage) {
      await app.store(stored);
      await app.reload();
      await app.connect();
      await expect.poll(() => app.valueOf('DT time'), { message: what }).toBe('3:00');
    }
  });

  test('after a later version has stored data in another way', async () => {
    const app = await AppPage.open({ bench: {}, before: () => void indexedDB.open('sidus-timer', 99) });
    await app.says(en.keeping.notKept);
    await app.connect();
  });

  const refusals: [how: string, before: () => void][] = [
    [
      'at once',
      () => {
        IDBFactory.prototype.open = () => {
          throw new DOMException('The storage is off.', 'SecurityError');
        };
      },
    ],
    [
      'when it is written to',
      () => {
        IDBObjectStore.prototype.put = () => {
          throw new DOMException('The storage is full.', 'QuotaExceededError');
        };
      },
    ],
  ];

  test.for(refusals)(
    'where the browser refuses to store, %s: typed text stays while the page is open',
    async ([, before]) => {
      const app = await AppPage.open({ bench: {}, before });
      await app.connect();
      await app.type('Function 2, S1', '7');
      await app.says(en.keeping.notKept);
      await app.fly('M2');
      await app.fly('M1');
      await expect.poll(() => app.valueOf('Function 2, S1')).toBe('7');
    },
  );

  test('where the storage was full, it is kept once there is room and the pilot comes back to the page', async () => {
    const app = await AppPage.open({
      bench: {},
      before: () => {
        const { put } = IDBObjectStore.prototype;
        IDBObjectStore.prototype.put = () => {
          throw new DOMException('The storage is full.', 'QuotaExceededError');
        };
        addEventListener('room', () => {
          IDBObjectStore.prototype.put = put;
        });
      },
    });
    await app.connect();
    await app.type('Function 2, S1', '7');
    await app.says(en.keeping.notKept);
    await app.page.evaluate(() => dispatchEvent(new Event('room')) && dispatchEvent(new Event('focus')));
    await app.text(en.keeping.notKept).waitFor({ state: 'detached' });
  });
});
