// Serves the built page. As a program (`npm start`) at a fixed address, for a person.

import { fileURLToPath } from 'node:url';
import { preview } from 'vite';

/** The headers that a host can send: see docs/hosting.md. */
const HEADERS = {
  'Content-Security-Policy': "frame-ancestors 'none'",
  'Permissions-Policy': 'serial=(self)',
  'X-Content-Type-Options': 'nosniff',
  'Cache-Control': 'no-cache',
};

/**
 * Serves the built page on this machine.
 * @param {{ port?: number, base?: string, folder?: string }} [options] port: 0 takes a free one; base: the path under
 * which the page lies; folder: of the build. Default: dist/site
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 */
export async function serve({ port = 0, base = '/', folder } = {}) {
  const server = await preview({
    base,
    ...(folder ? { build: { outDir: folder } } : {}),
    logLevel: 'warn',
    preview: { host: '127.0.0.1', port, strictPort: true, headers: HEADERS },
  });
  const address = /** @type {import('node:net').AddressInfo} */ (server.httpServer.address());
  return { url: `http://127.0.0.1:${address.port}${base}`, close: () => server.close() };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const port = 4173;
  try {
    const { url } = await serve({ port });
    console.log(`Sidus Timer: ${url}\nCtrl+C stops it.`);
  } catch (error) {
    console.error(String(error).includes('in use') ? `Port ${port} is taken: stop the program that uses it.` : error);
    process.exit(1);
  }
}
