import { createHash } from 'node:crypto';
import { readdirSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join, relative } from 'node:path';
import type { Page } from 'playwright';
import { onTestFinished } from 'vitest';
import { newPage } from './page.js';

/** The folder of the built page. */
export const SITE = join(import.meta.dirname, '../../dist/site');
const TYPES: Readonly<Record<string, string>> = {
  html: 'text/html',
  js: 'text/javascript',
  css: 'text/css',
  svg: 'image/svg+xml',
  png: 'image/png',
  webmanifest: 'application/manifest+json',
};

export type Answer = { readonly status?: number; readonly type?: string; readonly body: string | Uint8Array };

/** A host of the built page that can send wrong answers. */
export interface Host {
  readonly url: string;
  /** Its files, by address below the page. */
  readonly files: Map<string, string | Uint8Array>;
  /** Called before each answer. What it returns is sent instead. */
  lie: (address: string) => Answer | undefined;
}

/** Serves the built page for one test, as a plain host does. */
export async function openHost(): Promise<Host> {
  const names = readdirSync(SITE, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const files = new Map<string, string | Uint8Array>(
    names.map((entry) => {
      const path = join(entry.parentPath, entry.name);
      return [relative(SITE, path), readFileSync(path)];
    }),
  );
  const host = { url: '', files, lie: (_: string): Answer | undefined => undefined };
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://host');
    const address = pathname === '/' ? 'index.html' : pathname.slice(1);
    const kept = files.get(address);
    const type = TYPES[address.split('.').at(-1) ?? ''] ?? 'text/plain';
    const answer: Answer = host.lie(address) ?? (kept === undefined ? { status: 404, body: 'none' } : { body: kept });
    response.writeHead(answer.status ?? 200, { 'content-type': answer.type ?? type, 'cache-control': 'no-cache' });
    response.end(answer.body);
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  onTestFinished(() => {
    server.closeAllConnections();
    server.close();
  });
  host.url = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
  return host;
}

/** The host has a new version: another title, and a worker that knows it. */
export function publish({ files }: Host, title: string): void {
  const integrity = (body: string | Uint8Array): string =>
    `sha256-${createHash('sha256').update(body).digest('base64')}`;
  const before = String(files.get('index.html'));
  const after = before.replace(/<title>.*<\/title>/, `<title>${title}</title>`);
  files.set('index.html', after);
  files.set('sw.js', String(files.get('sw.js')).replace(integrity(before), integrity(after)));
}

/** The page has been visited once, and needs no network. */
export async function visited(): Promise<{ host: Host; page: Page; script: string }> {
  const host = await openHost();
  // What the browser reports about a wrong answer is not an error of the page.
  const page = await newPage({}, []);
  await page.goto(host.url);
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  const [, script = ''] = /src="\.\/(assets\/[\w-]+\.js)"/.exec(String(host.files.get('index.html'))) ?? [];
  return { host, page, script };
}

/** Looks for a new version until there is one. @returns how its worker ends */
export function update(page: Page): Promise<string> {
  return page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    let worker: ServiceWorker | null = null;
    // Listens from the moment it is found: a worker without files may end before the search does.
    registration.addEventListener('updatefound', () => {
      worker = registration.installing;
    });
    // The page may have begun a search before there was a new version, which then serves for this one.
    while (!worker) {
      await registration.update().catch(() => {});
      worker ??= registration.installing ?? registration.waiting;
    }
    const found: ServiceWorker = worker;
    while (found.state === 'installing' || found.state === 'parsed') {
      await new Promise((resolve) => found.addEventListener('statechange', resolve, { once: true }));
    }
    return found.state;
  });
}
