import { availableParallelism } from 'node:os';
import preact from '@preact/preset-vite';
import { playwright } from '@vitest/browser-playwright';
import { defineConfig } from 'vitest/config';
import { launchOptions } from './test/tools/browser.js';
import { sentences } from './test/tools/catalogue.js';

/** As many workers as there are cores; by default Vitest leaves one core idle. */
const maxWorkers = availableParallelism();

/**
 * The parts of the screen, fast in happy-dom; what only a real browser can tell, such as its storage, stands in
 * `*.browser.test.*`.
 */
const parts = {
  include: ['test/app/**/*.test.{ts,tsx}'],
  testTimeout: 600_000,
  hookTimeout: 600_000,
  maxWorkers,
};
const plugins = [preact({ include: [/\.tsx$/], prefreshEnabled: false, devToolsEnabled: false }), sentences()];

/**
 * For journeys in a browser on a slow and busy machine. No test judges how long something takes; these limits end what
 * hangs.
 */
const PATIENCE = { testTimeout: 600_000, hookTimeout: 600_000, expect: { poll: { timeout: 120_000 } } };

/**
 * Tests of the site that try many sizes, themes, papers, fingers, faults of a line or a browser, or versions, and the
 * two longest walks: `npm run test:matrix`. The journeys of a pilot stay in `npm test`.
 */
const MATRICES =
  'test/site/{by-ear,digits,first-picture,forced-colours,history,in-reach,in-sight,input,left-out,link,long-names,look,many-settings,package,preview,print,rows,season,services,share,tasks,touch,two-tabs,uncertain,update,wire,worker}.test.ts';
const site = {
  environment: 'node',
  globalSetup: ['test/site/setup.js', 'test/tools/pack-folder.js'],
  // One and a half times as many as there are cores: while one waits for its line, another works. More of them would
  // make each slower and the whole no quicker. They share a browser one after another.
  maxWorkers: Math.min(Math.ceil(1.5 * maxWorkers), 8),
  isolate: false,
  // Runs after the other floors.
  sequence: { groupOrder: 1 },
  ...PATIENCE,
};

/** One project for each floor of tests: a fault is caught on the lowest floor that can catch it. */
export default defineConfig({
  test: {
    projects: [
      {
        test: {
          name: 'unit',
          environment: 'node',
          include: [
            'test/{line,protocol,program,client,simulator,mock-serial,serial,english,fuzz,package}/**/*.test.ts',
            'test/{readme,docs}*.test.ts',
          ],
          globalSetup: 'test/tools/pack-folder.js',
          setupFiles: ['test/tools/seed.js'],
          maxWorkers,
          isolate: false,
          // Nothing waits here, but properties and packing take long on a busy machine.
          testTimeout: 600_000,
          hookTimeout: 600_000,
        },
      },
      {
        plugins,
        test: {
          ...parts,
          name: 'parts',
          environment: 'happy-dom',
          // Newer Nodes have a storage of their own, which stands in the way of happy-dom's.
          execArgv: 'localStorage' in globalThis ? ['--no-experimental-webstorage'] : [],
          setupFiles: ['test/tools/seed.js', 'test/app/setup.ts'],
          exclude: ['**/*.browser.test.ts'],
          // The files share modules and a document: setup.ts leaves nothing behind from one to the next.
          isolate: false,
        },
      },
      {
        plugins,
        test: {
          ...parts,
          name: 'parts-browser',
          include: ['test/app/**/*.browser.test.{ts,tsx}'],
          setupFiles: ['test/app/setup.ts'],
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
        plugins: [sentences()],
        test: { ...site, name: 'site', include: ['test/site/**/*.test.ts'], exclude: [MATRICES] },
      },
      { plugins: [sentences()], test: { ...site, name: 'site-matrix', include: [MATRICES] } },
      {
        plugins: [sentences()],
        test: {
          name: 'rig',
          environment: 'node',
          include: ['test/rig/**/*.test.ts'],
          globalSetup: 'test/rig/setup.ts',
          ...PATIENCE,
        },
      },
      {
        plugins: [sentences()],
        test: {
          ...site,
          name: 'site-firefox',
          include: ['test/site/{demo,library,link,recovery,start}.test.ts'],
        },
      },
      {
        plugins: [sentences()],
        test: {
          name: 'rig-firefox',
          environment: 'node',
          include: ['test/rig/{journey,unplug,chooser,mouse}.test.ts'],
          globalSetup: 'test/rig/setup.ts',
          ...PATIENCE,
        },
      },
    ],
  },
});
