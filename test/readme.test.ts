import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { transformWithOxc } from 'vite';
import { beforeAll, describe, expect, it } from 'vitest';
import { Consumer, packed, root } from './tools/pack.js';

/** The examples of the README and of the page about the package, in their order. */
const examples = ['README.md', 'docs/package.md', 'docs/npm-readme.md']
  .map((file) => readFileSync(join(root, file), 'utf8'))
  .flatMap((text) => [...text.matchAll(/```ts\n(.*?)```/gs)].map(([, code]) => code as string));
/** The examples of the pages of the API, by the file in whose comments they stand. */
const commented = readdirSync(join(root, 'src'), { recursive: true, encoding: 'utf8' })
  .filter((file) => file.endsWith('.ts') && !file.startsWith('app'))
  .flatMap((file) => {
    const text = readFileSync(join(root, 'src', file), 'utf8');
    const found = [...text.matchAll(/@example\n *\* ```ts\n(.*?) *\* ```/gs)];
    return found.map(([, code = '']) => ({ file, code: code.replace(/^ *\* ?/gm, '') }));
  });

let home: string;
let consumer: Consumer;
beforeAll(async () => {
  home = await packed();
  consumer = await Consumer.create();
});

describe('the packed package', () => {
  it('holds what it declares and nothing of the app', () => {
    const { exports } = JSON.parse(readFileSync(join(home, 'package.json'), 'utf8')) as {
      exports: Record<string, string | Record<string, string>>;
    };
    for (const entry of Object.values(exports)) {
      for (const file of Object.values(typeof entry === 'string' ? [entry] : entry)) {
        expect(existsSync(join(home, file)), `the package lacks ${file}`).toBe(true);
      }
    }
    expect(existsSync(join(home, 'LICENSE'))).toBe(true);
    expect(existsSync(join(home, 'src/app'))).toBe(false);
    expect(existsSync(join(home, 'dist/site'))).toBe(false);
  });

  it('shows on npm what it is, with links that lead somewhere from there, and leaves the README of the project', () => {
    const shown = readFileSync(join(home, 'README.md'), 'utf8');
    expect(shown).toMatch(/^# sidus-timer\n/);
    const links = [...shown.matchAll(/\]\(([^)]+)\)/g)].map(([, link = '']) => link);
    expect(links.length).toBeGreaterThan(4);
    for (const link of links) {
      const [, path = ''] = /^https:\/\/github\.com\/[^/]+\/[^/]+\/blob\/main\/([^#]+)/.exec(link) ?? [];
      expect(existsSync(join(root, path)), `this link leads nowhere: ${link}`).toBe(true);
    }
    expect(readFileSync(join(root, 'README.md'), 'utf8')).toMatch(/^# Sidus Timer\n/);
  });

  it('compiles for a strict consumer that has only the DOM library', () => {
    const all = [...examples, ...commented.map(({ code }) => code)];
    for (const [index, code] of all.entries()) consumer.write(`example-${index}.ts`, code);
    expect(consumer.compile()).toBe('');
  });
});

describe('the examples of the README and the docs', () => {
  it('are six, and do what their comments say', () => {
    expect(examples).toHaveLength(6);
    for (const [index, code] of examples.entries()) {
      consumer.write(`example-${index}.js`, code);
      const said = [...code.matchAll(/console\.log\(.*\/\/ (.*)/g)].map(([, comment]) => comment);
      const lines = consumer.run(process.execPath, `example-${index}.js`).trim().split('\n');
      expect(
        lines.filter((line) => line !== ''),
        `example ${index} of the docs prints what its comments say`,
      ).toEqual(said);
    }
  });

  it('of the API are a dozen or more, and do what their comments say', async () => {
    expect(commented.length).toBeGreaterThanOrEqual(12);
    for (const { file, code } of commented) {
      const { code: script } = await transformWithOxc(code, 'example.ts');
      const said = [...code.matchAll(/console\.log\(.*\/\/ (.*)/g)].flatMap(([, comment = '']) => comment.split(' | '));
      const lines = consumer.run(process.execPath, '--input-type=module', '--eval', script).trim().split('\n');
      expect(lines, `the example in ${file} prints what its comments say`).toEqual(said);
    }
  });

  it('show the frames that the package makes', () => {
    const shown = /Uint8Array ((?:[0-9a-f]{2} )+[0-9a-f]{2})/.exec(examples.join('\n'))?.[1];
    const script = `import { encodeFrame } from 'sidus-timer/protocol'; console.log(Buffer.from(encodeFrame(0x6b)).toString('hex'));`;
    expect(consumer.run(process.execPath, '--input-type=module', '--eval', script).trim()).toBe(
      shown?.replaceAll(' ', ''),
    );
  });
});
