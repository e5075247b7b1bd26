import { execSync } from 'node:child_process';
import { env } from 'node:process';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { launchOptions } from '../tools/browser.js';
import { serve } from '../tools/serve.js';

/**
 * Builds the page as it is published, once for all tests of it, and serves it at the root of a host and below one.
 * @param {{ provide: (name: string, value: unknown) => void }} project
 */
export async function setup({ provide }) {
  // In a process of its own: what Vitest sets in this one would not make a production build.
  execSync('npm run --silent build:site', {
    env: { ...env, NODE_ENV: 'production' },
    stdio: ['ignore', 'ignore', 'inherit'],
  });
  const atRoot = await serve();
  const underPath = await serve({ base: '/sub/path/' });
  provide('site', atRoot.url);
  provide('siteUnderPath', underPath.url);
  provide('launch', launchOptions());
  provide('workbench', await script('workbench.ts'));
  return async () => {
    await atRoot.close();
    await underPath.close();
  };
}

/**
 * One script of this folder with all that it imports, to be run in a page.
 * @param {string} file
 * @returns {Promise<string>}
 */
async function script(file) {
  const entry = fileURLToPath(new URL(file, import.meta.url));
  const built = await build({
    configFile: false,
    logLevel: 'warn',
    build: { write: false, target: 'es2022', lib: { entry, formats: ['iife'], name: 'script' } },
  });
  const [output] = [built].flat();
  if (!output || !('output' in output)) throw new Error(`${file} was not built.`);
  return output.output[0].code;
}
