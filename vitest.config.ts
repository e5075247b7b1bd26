import preact from '@preact/preset-vite';
import { playwright } from '@vitest/browser-playwright';
import { defineConfig } from 'vitest/config';
import { launchOptions } from './test/tools/browser.js';

/**
 * The parts of the screen, fast in happy-dom; what only a real browser can tell, such as its storage, stands in
 * `*.browser.test.*`.
 */
const parts = {
  include: ['test/app/**/*.test.{ts,tsx}'],
  setupFiles: ['test/app/setup.ts'],
  testTimeout: 600_000,
};
const plugins = [preact({ include: [/\.tsx$/], prefreshEnabled: false, devToolsEnabled: false })];

/**
 * A journey in a browser on a slow and busy machine: nothing is judged by how long it takes, and the limits are there
 * for what hangs.
 */
const PATIENCE = { testTimeout: 600_000, hookTimeout: 600_000, expect: { poll: { timeout: 120_000 } } };

/** One project for each floor of tests: a fault is caught on the lowest floor that can catch it. */
export default defineConfig({
  test: {
    projects: [
      {
        test: {
          name: 'unit',
          environment: 'node',
          include: [
            'test/{line,protocol,program,client,simulator,mock-serial,serial,fuzz,package}/**/*.test.ts',
            'test/{readme,docs}*.test.ts',
          ],
          globalSetup: 'test/tools/pack-folder.js',
          // Nothing waits here, but properties take their time on a busy machine, and packing does.
          testTimeout: 600_000,
          hookTimeout: 600_000,
        },
      },
      {
        plugins,
        test: { ...parts, name: 'parts', environment: 'happy-dom', exclude: ['**/*.browser.test.ts'] },
      },
      {
        plugins,
        test: {
          ...parts,
          name: 'parts-browser',
          include: ['test/app/**/*.browser.test.{ts,tsx}'],
          browser: {
            enabled: true,
            headless: true,
            screenshotFailures: false,
            provider: playwright({ launchOptions: launchOptions() }),
            instances: [{ browser: 'chromium' }],
          },
        },
      },
      {
        test: {
          name: 'site',
          environment: 'node',
          include: ['test/site/**/*.test.ts'],
          globalSetup: ['test/site/setup.js', 'test/tools/pack-folder.js'],
          // A journey mostly waits for the line: several can run side by side.
          maxWorkers: 3,
          // Its turn comes when the other floors are done.
          sequence: { groupOrder: 1 },
          ...PATIENCE,
        },
      },
      {
        test: {
          name: 'rig',
          environment: 'node',
          include: ['test/rig/**/*.test.ts'],
          globalSetup: 'test/rig/setup.ts',
          ...PATIENCE,
        },
      },
    ],
  },
});
