import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build } from 'vite';
import { describe, expect, onTestFinished, test } from 'vitest';
import { LICENCES_FILE, licencesOf, ownWorkOnly } from '../tools/licences.js';

const ROOT = join(import.meta.dirname, '../..');
const APP = join(ROOT, 'src/app');
const SITE = join(ROOT, 'dist/site');

/** The packages that the source of the page names, whatever the build makes of them. */
function named(): Set<string> {
  const files = readdirSync(APP, { recursive: true, encoding: 'utf8' }).filter((name) => /\.(tsx?|css)$/.test(name));
  const specifiers = files.flatMap((file) => {
    const source = readFileSync(join(APP, file), 'utf8').replace(/^import type .*$/gm, '');
    return [...source.matchAll(/(?:from |import\(?|@import )\s*['"]((?:@[\w-]+\/)?[a-z][\w-]*)(?:\/[\w./-]*)?['"]/g)];
  });
  return new Set(specifiers.map(([, name]) => name as string));
}

/** A project with one package in it, as npm lays it. */
function projectWith(files: Record<string, string>): string {
  const root = mkdtempSync(join(tmpdir(), 'sidus-timer-licences-'));
  onTestFinished(() => rmSync(root, { recursive: true, force: true }));
  const folder = join(root, 'node_modules/other');
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(root, 'package.json'), '{ "name": "own", "version": "1.0.0", "license": "MIT" }');
  writeFileSync(join(root, 'LICENSE'), 'Own text');
  writeFileSync(join(root, 'own.js'), 'console.log(1);');
  writeFileSync(
    join(folder, 'package.json'),
    '{ "name": "other", "version": "2.1.0", "license": "(MIT OR Apache-2.0)" }',
  );
  writeFileSync(join(folder, 'index.js'), 'console.log(2);');
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  return root;
}

describe('the licences of the built page', () => {
  const text = readFileSync(join(SITE, LICENCES_FILE), 'utf8');

  test('name this page, and every package of which it contains anything, with a text', () => {
    const heads = [...text.matchAll(/^(@?[a-z][\w@/-]*) \d+\.\d+\.\d+, .+$/gm)].map(([, name]) => name);
    expect(heads).toEqual(expect.arrayContaining(['sidus-timer', '@preact/signals-core', 'vite', ...named()]));
    expect(named()).toContain('@fontsource-variable/inter');
    expect(named().size).toBeGreaterThan(5);
    expect(text).toContain('SIL OPEN FONT LICENSE');
    for (const part of text.split(/^-{80}$/m).slice(1))
      expect(part.length, `this licence has no text: ${part.slice(0, 40)}`).toBeGreaterThan(500);
  });
});

describe('a package', () => {
  test('with two licences uses the shorter one', () => {
    const root = projectWith({ LICENSE: 'Long text', 'LICENSE-MIT': 'Short text\r\n' });
    expect(licencesOf([join(root, 'own.js'), join(root, 'node_modules/other/index.js')], root)).toEqual([
      { name: 'own', version: '1.0.0', licence: 'MIT', text: 'Own text' },
      { name: 'other', version: '2.1.0', licence: 'MIT OR Apache-2.0', text: 'Short text' },
    ]);
  });

  test('without a licence text fails the build', () => {
    for (const files of [{}, { LICENSE: ' \n' }]) {
      const root = projectWith(files as Record<string, string>);
      expect(() => licencesOf([join(root, 'node_modules/other/index.js')], root)).toThrow(/^other is in the page/);
    }
  });

  test('in the worker fails the build', async () => {
    const root = projectWith({ LICENSE: 'Text' });
    const built = (entry: string) =>
      build({
        configFile: false,
        root,
        logLevel: 'silent',
        plugins: [ownWorkOnly(root)],
        build: { write: false, rolldownOptions: { input: join(root, entry) } },
      });
    await built('own.js');
    writeFileSync(join(root, 'own.js'), `import 'other';`);
    await expect(built('own.js')).rejects.toThrow(/other.* is in this script/);
  });
});
