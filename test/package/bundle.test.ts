import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { build, type Rolldown } from 'vite';
import { afterAll, beforeAll, describe, expect, it, vi } from 'vitest';
import { Consumer } from '../tools/pack.js';

let consumer: Consumer;
beforeAll(async () => {
  consumer = await Consumer.create();
  // What Vitest sets would not make a production build.
  vi.stubEnv('NODE_ENV', 'production');
});
afterAll(() => vi.unstubAllEnvs());

/** A program of these lines as one minified file, and the modules of which something is in it. */
async function bundle(lines: string): Promise<{ code: string; modules: string[] }> {
  consumer.write('main.js', lines);
  const built = (await build({
    configFile: false,
    root: consumer.folder,
    logLevel: 'error',
    build: {
      write: false,
      target: 'es2022',
      modulePreload: false,
      rolldownOptions: { input: join(consumer.folder, 'main.js') },
    },
  })) as Rolldown.RolldownOutput;
  const [chunk, ...others] = built.output;
  expect(others, 'the bundle is one file').toEqual([]);
  const modules = Object.entries(chunk.modules)
    .filter(([, { renderedLength }]) => renderedLength > 0)
    .map(([path]) => /sidus-timer\/dist\/lib\/(.*)$/.exec(path)?.[1] ?? '')
    .filter((path) => path !== '');
  return { code: chunk.code, modules };
}

describe('a bundle takes what it uses', () => {
  for (const entry of ['sidus-timer/protocol', 'sidus-timer']) {
    it(`encodeFrame of ${entry} is under 1 kB`, async () => {
      const { code, modules } = await bundle(
        `import { encodeFrame } from '${entry}'; globalThis.frame = encodeFrame(0x6b);`,
      );
      expect(Buffer.byteLength(code)).toBeLessThan(1000);
      expect(modules.sort()).toEqual(['protocol/errors.js', 'protocol/frame.js']);
      consumer.write('bundle.js', `${code}\nconsole.log(Buffer.from(globalThis.frame).toString('hex'));`);
      expect(consumer.run(process.execPath, 'bundle.js').trim()).toBe('0000000000036b6b45');
    });
  }

  it('a decoder brings no codec, a client no simulator, and nothing brings the page', async () => {
    const decoder = await bundle(
      `import { FrameDecoder } from 'sidus-timer'; globalThis.frames = new FrameDecoder().push(new Uint8Array(9));`,
    );
    expect(decoder.modules.sort()).toEqual(['protocol/decoder.js', 'protocol/frame.js']);
    const client = await bundle(`import { TimerClient } from 'sidus-timer'; globalThis.client = TimerClient;`);
    const rooms = new Set(client.modules.map((path) => path.split('/')[0]));
    expect(rooms).toEqual(new Set(['client', 'line', 'program', 'protocol']));
    expect(client.code).not.toMatch(/preact|idb|valibot/);
  });

  it('the classic script is kept when it is imported for what it does', async () => {
    const { code } = await bundle(`import 'sidus-timer/mock-serial.global.js';`);
    expect(code).toContain('SidusMockSerial');
  });
});

describe('the vectors', () => {
  it('are loaded from the installed package, by import and by require, and so is package.json', () => {
    const script = `import { createRequire } from 'node:module';
      import imported from 'sidus-timer/vectors.json' with { type: 'json' };
      const require = createRequire(import.meta.url);
      const same = JSON.stringify(imported) === JSON.stringify(require('sidus-timer/vectors.json'));
      console.log(imported.version, same, require('sidus-timer/package.json').name);`;
    const said = consumer.run(process.execPath, '--no-warnings', '--input-type=module', '--eval', script);
    expect(said.trim()).toBe('1 true sidus-timer');
  });

  it('are those that the codecs are tested with', () => {
    const script = `import { createRequire } from 'node:module';
      console.log(createRequire(import.meta.url).resolve('sidus-timer/vectors.json'));`;
    const path = consumer.run(process.execPath, '--input-type=module', '--eval', script).trim();
    expect(readFileSync(path, 'utf8')).toBe(readFileSync(new URL('../vectors.json', import.meta.url), 'utf8'));
  });
});
