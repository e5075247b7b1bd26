import { execFileSync, execSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { env } from 'node:process';
import type { TestProject } from 'vitest/node';
import { beside } from './box.js';
import { requireNeeds } from './needs.js';

declare module 'vitest' {
  interface ProvidedContext {
    /** The folder with the page that the rig has built. */
    builtPage: string;
    /** The library with which Firefox takes a pty for a serial port; undefined in Chromium. */
    modem: string | undefined;
  }
}

/**
 * Once for all tests of the rig: looks for what they need, and builds the page as it is published, in a folder of its
 * own.
 */
export function setup(project: TestProject): () => void {
  const isFirefox = project.name === 'rig-firefox';
  requireNeeds(isFirefox ? 'firefox' : 'chromium');
  const folder = mkdtempSync(join(tmpdir(), 'sidus-page-'));
  const remove = () => rmSync(folder, { recursive: true, force: true });
  const page = join(folder, 'page');
  const modem = isFirefox ? join(folder, 'modem.so') : undefined;
  try {
    if (modem) execFileSync('cc', ['-shared', '-fPIC', '-Wall', '-Werror', '-o', modem, beside('modem.c')]);
    // In a process of its own: what Vitest sets in this one would not make a production build.
    execSync(`npm run --silent build:site -- --outDir "${page}" --emptyOutDir`, {
      // The build leaves things in the folder for temporary files.
      env: { ...env, NODE_ENV: 'production', TMPDIR: folder },
      stdio: ['ignore', 'ignore', 'inherit'],
    });
  } catch (error) {
    remove();
    throw error;
  }
  project.provide('builtPage', page);
  project.provide('modem', modem);
  return remove;
}
