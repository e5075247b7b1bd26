import { execSync } from 'node:child_process';
import { env } from 'node:process';
import { FIREFOX, launchOptions } from '../tools/browser.js';
import { serve } from '../tools/serve.js';
import { workbenchScript } from '../tools/workbench-script.js';

/**
 * Builds the page as it is published, once for all tests of it, and serves it at the root of a host and below one.
 * @param {{ name: string, provide: (name: string, value: unknown) => void }} project
 */
export async function setup({ name, provide }) {
  // In a process of its own: what Vitest sets in this one would not make a production build.
  execSync('npm run --silent build:site', {
    env: { ...env, NODE_ENV: 'production' },
    stdio: ['ignore', 'ignore', 'inherit'],
  });
  const atRoot = await serve();
  const underPath = await serve({ base: '/sub/path/' });
  provide('site', atRoot.url);
  provide('siteUnderPath', underPath.url);
  provide('launch', name === 'site-firefox' ? FIREFOX : launchOptions());
  provide('workbench', await workbenchScript());
  return async () => {
    await atRoot.close();
    await underPath.close();
  };
}
