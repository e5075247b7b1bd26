// Runs the tests of a room for Stryker in this process, on modules that stay loaded: a mutant then takes milliseconds,
// where a start of Vitest for each takes seconds. Stryker itself watches the time and starts a new process after an
// endless loop.

import { readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { createServer, createServerModuleRunner } from 'vite';
import { testFilesOf } from './rooms.js';
import { api, gathered } from './test-api.js';

/** Milliseconds that each test took without a mutant, for all processes. */
const DURATIONS = 'durations.json';

/** Stands for Vitest. */
globalThis.testApiOfMutants = api;
const VITEST = `export const { ${Object.keys(api).join(', ')} } = globalThis.testApiOfMutants;`;

const standIns = {
  name: 'stand-ins',
  enforce: 'pre',
  resolveId(id) {
    if (id === 'vitest') return '\0vitest';
    if (id === 'fast-check') return fileURLToPath(new URL('fast-check.js', import.meta.url));
  },
  load: (id) => (id === '\0vitest' ? VITEST : undefined),
};

/** Where the changed code asks which mutant is active, and tells what is covered. */
function strykerNamespace() {
  globalThis.__stryker__ ??= {};
  return globalThis.__stryker__;
}

class RoomRunner {
  #room = process.env.MUTANTS_ROOM;
  #server;
  #modules;
  /** By their name. */
  #tests = new Map();
  #stryker = strykerNamespace();

  capabilities() {
    return { reloadEnvironment: true };
  }

  async init() {
    // What a mutant leaves behind comes to light during another one: it tells nothing of that.
    process.on('unhandledRejection', () => {});
    process.on('uncaughtException', () => {});
    this.#server = await createServer({
      configFile: false,
      root: process.cwd(),
      logLevel: 'error',
      plugins: [standIns],
      server: { middlewareMode: true, watch: null, hmr: false, ws: false },
      optimizeDeps: { noDiscovery: true },
      ssr: { noExternal: ['vitest', 'fast-check'] },
    });
    this.#modules = createServerModuleRunner(this.#server.environments.ssr, { hmr: false });
  }

  async dryRun() {
    await this.#load();
    const results = [];
    for (const [id, run] of this.#tests) {
      this.#stryker.currentTestId = id;
      const begin = performance.now();
      const failure = await failureOf(run);
      this.#stryker.currentTestId = undefined;
      const timeSpentMs = performance.now() - begin;
      const status = failure === undefined ? { status: 0 } : { status: 1, failureMessage: failure };
      results.push({ id, name: id, timeSpentMs, ...status });
    }
    writeFileSync(
      DURATIONS,
      JSON.stringify(Object.fromEntries(results.map(({ id, timeSpentMs }) => [id, timeSpentMs]))),
    );
    return { status: 'complete', tests: results, mutantCoverage: this.#stryker.mutantCoverage };
  }

  async mutantRun({ activeMutant, hitLimit, testFilter, mutantActivation, reloadEnvironment }) {
    const stryker = this.#stryker;
    Object.assign(stryker, { hitLimit, hitCount: 0, activeMutant: undefined });
    if (mutantActivation === 'static') stryker.activeMutant = activeMutant.id;
    if (this.#tests.size === 0 || reloadEnvironment) {
      const failure = await failureOf(() => this.#load());
      if (failure !== undefined) return killed('loading', failure, 0);
    }
    stryker.activeMutant = activeMutant.id;
    const tests = quickestFirst(testFilter ?? [...this.#tests.keys()]);
    let nrOfTests = 0;
    for (const id of tests) {
      nrOfTests++;
      const failure = await failureOf(this.#tests.get(id));
      if (stryker.hitCount > hitLimit) return { status: 'timeout', reason: 'an endless loop' };
      if (failure !== undefined) return killed(id, failure, nrOfTests);
    }
    return { status: 'survived', nrOfTests };
  }

  async dispose() {
    await this.#server?.close();
  }

  /** Loads all modules afresh, and gathers the tests. */
  async #load() {
    this.#modules.clearCache();
    this.#tests.clear();
    for (const file of testFilesOf(this.#room)) {
      const tests = await gathered(() => this.#modules.import(resolve(file)));
      for (const [index, { name, run }] of tests.entries()) this.#tests.set(`${file}: ${name} (${index})`, run);
    }
  }
}

function killed(killedBy, failureMessage, nrOfTests) {
  return { status: 'killed', killedBy: [killedBy], failureMessage, nrOfTests };
}

/** What a function throws, as a text; undefined when it throws nothing. */
async function failureOf(run) {
  try {
    await run();
  } catch (error) {
    return String(error instanceof Error ? error.message : error);
  }
}

function quickestFirst(ids) {
  const durations = JSON.parse(readFileSync(DURATIONS, 'utf8'));
  return ids.sort((a, b) => durations[a] - durations[b]);
}

export const strykerPlugins = [{ kind: 'TestRunner', name: 'room', injectableClass: RoomRunner }];
