// The page of the package on npm is docs/npm-readme.md, with its links made absolute: npm shows only README.md.
// `put` replaces README.md before packing, `back` undoes that. The next run undoes an interrupted one.

import { copyFileSync, existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const readme = `${root}README.md`;
const kept = `${root}dist/README.md`;

/**
 * A page of the docs for any place: its relative links lead to the repository.
 * @param {string} text
 * @param {string} repository such as `https://github.com/owner/name`
 * @returns {string}
 */
export function withAbsoluteLinks(text, repository) {
  return text.replace(/\]\((?!https?:|#)([^)]+)\)/g, (_, link) => {
    const path = new URL(link, 'file:///docs/').pathname.slice(1);
    const [, hash = ''] = String(link).split('#');
    return `](${repository}/blob/main/${path}${hash && `#${hash}`})`;
  });
}

/** The page of the package, as npm will show it. */
export function packageReadme() {
  const { repository } = JSON.parse(readFileSync(`${root}package.json`, 'utf8'));
  const address = String(repository.url).replace(/^git\+|\.git$/g, '');
  return withAbsoluteLinks(readFileSync(`${root}docs/npm-readme.md`, 'utf8'), address);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  if (existsSync(kept)) renameSync(kept, readme);
  if (process.argv[2] === 'put') {
    mkdirSync(`${root}dist`, { recursive: true });
    copyFileSync(readme, kept);
    writeFileSync(readme, packageReadme());
  }
}
