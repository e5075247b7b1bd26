import { expect, inject, test } from 'vitest';
import { newPage } from './page.js';

/** What a browser may lack, refuse or never answer; put in place before the page begins. */
const faults: [what: string, breakIt: () => void, said: RegExp | null][] = [
  ['no indexedDB', () => Object.defineProperty(window, 'indexedDB', { value: undefined }), /It has no storage/],
  [
    'an indexedDB that cannot be touched',
    () =>
      Object.defineProperty(window, 'indexedDB', {
        get: () => {
          throw new DOMException('Not here.', 'SecurityError');
        },
      }),
    /It has no storage/,
  ],
  [
    'indexedDB.open that throws',
    () => {
      IDBFactory.prototype.open = () => {
        throw new DOMException('Not now.', 'InvalidStateError');
      };
    },
    /Its storage fails/,
  ],
  [
    'indexedDB.open that never answers',
    () => {
      const { open } = IDBFactory.prototype;
      IDBFactory.prototype.open = function (name) {
        return Object.assign(open.call(this, `other ${name}`), { addEventListener: () => {} });
      };
    },
    /Its storage does not answer/,
  ],
  [
    'no locks',
    () => Object.defineProperty(Navigator.prototype, 'locks', { value: undefined }),
    /cannot tell its tabs apart/,
  ],
  [
    'locks that cannot be touched',
    () =>
      Object.defineProperty(Navigator.prototype, 'locks', {
        get: () => {
          throw new DOMException('Not here.', 'SecurityError');
        },
      }),
    /cannot tell its tabs apart/,
  ],
  [
    'locks that throw',
    () => {
      LockManager.prototype.request = () => {
        throw new TypeError('no');
      };
    },
    /cannot tell its tabs apart/,
  ],
  [
    'locks that never answer',
    () => {
      LockManager.prototype.request = () => new Promise(() => {});
    },
    /cannot tell its tabs apart/,
  ],
  ['no channel', () => Reflect.deleteProperty(window, 'BroadcastChannel'), /This page does not notice its other tabs/],
  [
    'a channel that throws',
    () =>
      Object.assign(window, {
        BroadcastChannel: class {
          constructor() {
            throw new DOMException('Not here.', 'SecurityError');
          }
        },
      }),
    /This page does not notice its other tabs/,
  ],
  [
    'a channel that says nothing',
    () => {
      BroadcastChannel.prototype.postMessage = () => {
        throw new DOMException('closed', 'InvalidStateError');
      };
    },
    null,
  ],
  ...(['localStorage', 'sessionStorage'] as const).map((place): [string, () => void, RegExp] => [
    `a ${place} that cannot be touched`,
    place === 'localStorage'
      ? () =>
          Object.defineProperty(window, 'localStorage', {
            get: () => {
              throw new DOMException('Not here.', 'SecurityError');
            },
          })
      : () =>
          Object.defineProperty(window, 'sessionStorage', {
            get: () => {
              throw new DOMException('Not here.', 'SecurityError');
            },
          }),
    /other choices last only while this page is open/,
  ]),
  [
    'no service worker',
    () => Reflect.deleteProperty(Navigator.prototype, 'serviceWorker'),
    /you cannot open it without a network/,
  ],
  [
    'a service worker that cannot be registered',
    () => {
      ServiceWorkerContainer.prototype.register = () => Promise.reject(new DOMException('Not here.', 'SecurityError'));
    },
    /you cannot open it without a network/,
  ],
  ['no matchMedia', () => Reflect.deleteProperty(window, 'matchMedia'), null],
  ['no storage manager', () => Object.defineProperty(Navigator.prototype, 'storage', { value: undefined }), null],
  [
    'no caches',
    () =>
      Object.defineProperty(window, 'caches', {
        get: () => {
          throw new DOMException('Not here.', 'SecurityError');
        },
      }),
    null,
  ],
  [
    'serial ports that cannot be touched',
    () =>
      Object.defineProperty(Navigator.prototype, 'serial', {
        get: () => {
          throw new DOMException('Not here.', 'SecurityError');
        },
      }),
    null,
  ],
  [
    'serial ports that never answer',
    () => {
      Serial.prototype.getPorts = () => new Promise(() => {});
    },
    null,
  ],
];

test.for(faults)('with %s the page is drawn and works', async ([, breakIt, said]) => {
  const page = await newPage();
  await page.addInitScript(breakIt);
  await page.goto(inject('site'));
  await page.getByRole('button', { name: 'Try a simulated F1Q timer' }).waitFor();
  if (said) await page.getByRole('status').filter({ hasText: said }).waitFor();
  await page.getByRole('button', { name: 'Try a simulated F1Q timer' }).click();
  const field = page.getByRole('textbox', { name: 'DT time' });
  await field.fill('4:00');
  expect(await field.inputValue()).toBe('4:00');
});

test('a newer storage has its own sentence', async () => {
  const page = await newPage();
  await page.route('**/*', (route) => route.fulfill({ body: '<!doctype html>', contentType: 'text/html' }));
  await page.goto(inject('site'));
  await page.evaluate(
    () =>
      new Promise((resolve) => {
        const opening = indexedDB.open('sidus-timer', 1000);
        opening.onsuccess = () => resolve(opening.result.close());
      }),
  );
  await page.unroute('**/*');
  await page.goto(inject('site'));
  await page.getByText(/A newer version of this page has changed its storage/).waitFor();
});

test('inside of a frame the page does not work, and says where it does', async () => {
  const page = await newPage({}, []);
  await page.route('**/outer', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<iframe src="${inject('site')}" width="600" height="400"></iframe>`,
    }),
  );
  // As from a host that cannot send the header which shuts frames out by itself.
  await page.route(inject('site'), async (route) => {
    const response = await route.fetch();
    const { 'content-security-policy': _, ...headers } = response.headers();
    await route.fulfill({ response, headers });
  });
  await page.goto(`${new URL(inject('site')).origin}/outer`);
  const frame = page.frameLocator('iframe');
  await frame.getByRole('heading', { name: 'Sidus Timer works only in a tab of its own.' }).waitFor();
  expect(await frame.getByRole('button').count()).toBe(0);
  expect(await frame.getByRole('link').getAttribute('href')).toBe(inject('site'));
});
