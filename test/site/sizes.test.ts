import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { expect, test } from 'vitest';

const SITE = join(import.meta.dirname, '../../dist/site');

/** The size of a script as it is sent, in kB. */
function weightOf(file: string): number {
  return gzipSync(readFileSync(join(SITE, file))).length / 1000;
}

function sum(files: Iterable<string>): number {
  return [...files].reduce((total, file) => total + weightOf(file), 0);
}

/** A script, the scripts that it imports at its top, and so on. */
function withImports(file: string, known = new Set<string>()): Set<string> {
  known.add(file);
  for (const [, name] of readFileSync(join(SITE, file), 'utf8').matchAll(/(?:from|import)\s*"\.\/([\w-]+\.js)"/g)) {
    if (!known.has(`assets/${name}`)) withImports(`assets/${name}`, known);
  }
  return known;
}

test('at most 60 kB of script come before the first picture, and no more than needed before the page works', () => {
  const html = readFileSync(join(SITE, 'index.html'), 'utf8');
  const scripts = readdirSync(join(SITE, 'assets'))
    .filter((name) => name.endsWith('.js'))
    .map((name) => `assets/${name}`);
  const named = [...html.matchAll(/(?:src|href)="\.\/(assets\/[\w-]+\.js)"/g)].map(([, file]) => file as string);
  const first = new Set(named.flatMap((file) => [...withImports(file)]));
  const page = withImports(scripts.find((file) => file.startsWith('assets/open-page-')) ?? '');
  const working = new Set([...first, ...page]);
  // Of each language one file for the page, and a smaller one for its parts. One language is loaded.
  const languageOf = (file: string): string | undefined => /^assets\/([a-z]{2})-[\w-]{8}\.js$/.exec(file)?.[1];
  const languages = [...new Set(scripts.flatMap((file) => languageOf(file) ?? []))].map((language) => {
    const files = scripts.filter((file) => languageOf(file) === language);
    const [more = 0, page = 0] = files.map(weightOf).sort((a, b) => a - b);
    return { language, page, more };
  });
  const longest = (part: 'page' | 'more'): number => Math.max(...languages.map((each) => each[part]));
  const scriptsOnly = scripts.filter((file) => !languageOf(file));
  const stage = (file: string): number => (first.has(file) ? 1 : working.has(file) ? 2 : 3);
  const rows = scriptsOnly
    .toSorted((a, b) => stage(a) - stage(b) || weightOf(b) - weightOf(a))
    .map((file) => `${stage(file)} ${weightOf(file).toFixed(1).padStart(6)} ${file}`);
  const table = [
    'Scripts, kB compressed: 1 before the first picture, 2 before the page works, 3 its parts, fetched after that',
    ...rows,
    'A language: before the page works, then for its parts',
    ...languages.map(({ language, page, more }) => `${language} ${page.toFixed(1)} + ${more.toFixed(1)}`),
    `1: ${sum(first).toFixed(1)}, with 2: ${(sum(working) + longest('page')).toFixed(1)}, all: ${(
      sum(scriptsOnly) + longest('page') + longest('more')
    ).toFixed(1)}, with the longest language`,
  ].join('\n');
  process.stdout.write(`${table}\n`);
  expect(sum(first), table).toBeGreaterThan(1);
  expect(sum(first), table).toBeLessThanOrEqual(60);
  expect(languages.length, table).toBeGreaterThan(1);
  expect(sum(working) + longest('page'), table).toBeLessThanOrEqual(135);
});
