import { once } from 'node:events';
import { copyFileSync, mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { type AddressInfo, createServer } from 'node:net';
import { delimiter, dirname, extname, join } from 'node:path';
import process from 'node:process';
import type { Page } from 'playwright';
import { afterAll, beforeAll, describe, expect, test, vi } from 'vitest';
import type {} from '../../src/mock-serial/global.js';
import { findBrowser } from '../tools/browser.js';
import { Consumer, packed, root } from '../tools/pack.js';
import { newPage } from './page.js';

let home: string;
beforeAll(async () => {
  home = await packed();
  vi.stubEnv('NODE_ENV', 'production');
});
afterAll(() => vi.unstubAllEnvs());

const ORIGIN = 'http://127.0.0.1:9';
const TYPES: Record<string, string> = { '.html': 'text/html', '.js': 'text/javascript' };

/** A page at an address without a server: its files are those of the examples and of the installed package. */
async function pageOf(path: string): Promise<Page> {
  const page = await newPage();
  await page.route(`${ORIGIN}/**`, (route) => {
    const { pathname } = new URL(route.request().url());
    if (pathname === '/favicon.ico' || pathname === '/empty.html')
      return route.fulfill({ contentType: 'text/html', body: '' });
    const file = join(pathname.startsWith('/dist/') ? home : root, pathname);
    return route.fulfill({ contentType: TYPES[extname(file)] ?? 'text/plain', body: readFileSync(file) });
  });
  await page.addInitScript({ path: join(home, 'dist/lib/mock-serial.global.js') });
  await page.addInitScript(() => {
    const serial = new globalThis.SidusMockSerial.MockSerial({ userActivation: true });
    Object.defineProperty(navigator, 'serial', { value: serial });
    Object.assign(window, { serial });
  });
  await page.goto(ORIGIN + path);
  return page;
}

test('the client works unchanged in a module worker, on streams that the page transfers', async () => {
  const page = await pageOf('/empty.html');
  await page.route(`${ORIGIN}/worker.js`, (route) =>
    route.fulfill({
      contentType: 'text/javascript',
      body: `import { TimerClient } from '/dist/lib/client/public.js';
        onmessage = async ({ data: port }) => {
          const timer = new TimerClient(port);
          const program = await timer.readProgram();
          await timer.close();
          postMessage(program);
        };`,
    }),
  );
  // A string: what Vitest makes of import() would not be known in the page.
  const program = await page.evaluate(`(async () => {
    const { VirtualTimer } = await import('/dist/lib/simulator/public.js');
    const { readable, writable } = new VirtualTimer();
    const worker = new Worker('/worker.js', { type: 'module' });
    const answer = new Promise((resolve, reject) => {
      worker.addEventListener('message', ({ data }) => resolve(data));
      worker.addEventListener('error', ({ message }) => reject(new Error(message)));
    });
    worker.postMessage({ readable, writable }, [readable, writable]);
    return answer;
  })()`);
  expect(program).toMatchObject({ identity: { timerClass: 'B', functions: 10 }, memory: 0 });
});

/** A port of this machine on which nothing listens. */
async function freePort(): Promise<number> {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address() as AddressInfo;
  server.close();
  await once(server, 'close');
  return port;
}

test('the example tests of a page pass in Playwright, with the mock port put into the page', async () => {
  const consumer = await Consumer.create();
  consumer.link('playwright');
  consumer.link('vite');
  mkdirSync(join(consumer.folder, 'node_modules/@playwright/test'), { recursive: true });
  // This project has Playwright without the package of its runner, which contains only this line.
  consumer.write('node_modules/@playwright/test/package.json', '{ "type": "module", "exports": "./index.js" }');
  consumer.write('node_modules/@playwright/test/index.js', `export * from 'playwright/test';`);
  for (const file of readdirSync(join(root, 'examples/mock-port'))) {
    if (/^(thermometer|playwright)\b/.test(file)) {
      copyFileSync(join(root, 'examples/mock-port', file), join(consumer.folder, file));
    }
  }
  const { PATH = '' } = process.env;
  consumer.env = {
    CHROME_PATH: findBrowser() ?? '',
    PORT: String(await freePort()),
    PATH: [join(root, 'node_modules/.bin'), PATH].join(delimiter),
  };
  const cli = join(root, 'node_modules/playwright/cli.js');
  const told = consumer.tell(process.execPath, cli, 'test', '--reporter=line', '--timeout=0');
  expect(told).toMatchObject({ code: 0, said: expect.stringContaining('1 passed') });
});

describe('the example of one plain page', () => {
  test('shows which timer is there, and its times', async () => {
    const page = await pageOf('/examples/plain-html/index.html');
    // A string: what Vitest makes of import() would not be known in the page.
    await page.evaluate(`(async () => {
      const { VirtualTimer } = await import('/dist/lib/simulator/public.js');
      const port = serial.plug();
      serial.choose(port);
      port.device.join(new VirtualTimer());
    })()`);
    await page.getByRole('button', { name: 'Connect' }).click();
    await page.getByText('Class B, firmware 536, memory 1').waitFor();
    const row = page.getByRole('row', { name: 'DT' });
    await expect.poll(() => row.textContent()).toMatch(/DT\s*180\.00/);
    await expect.poll(() => page.getByRole('row').count()).toBe(12);
    await expect.poll(() => page.getByRole('button', { name: 'Connect' }).isEnabled()).toBe(true);
  });

  test('says why it could not, by name', async () => {
    const page = await pageOf('/examples/plain-html/index.html');
    await page.getByRole('button', { name: 'Connect' }).click();
    await page.getByText('(NotFoundError)').waitFor();
  });

  test('loads the files of its import map from its own folder', () => {
    const html = readFileSync(join(root, 'examples/plain-html/index.html'), 'utf8');
    const { imports } = JSON.parse(/<script type="importmap">(.*?)<\/script>/s.exec(html)?.[1] ?? '') as {
      imports: Record<string, string>;
    };
    const { exports } = JSON.parse(readFileSync(join(home, 'package.json'), 'utf8')) as {
      exports: Record<string, { default: string }>;
    };
    for (const [name, path] of Object.entries(imports)) {
      const named = exports[name.replace('sidus-timer', '.')]?.default ?? '';
      expect(join(dirname('/examples/plain-html/index.html'), path)).toBe(join('/', named));
    }
  });
});
