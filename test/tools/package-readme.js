// The page of the package on npm is docs/npm-readme.md, with its links made absolute: npm shows only README.md.
// `put` replaces README.md before packing, `back` undoes that. The next run undoes an interrupted one.

import { copyFileSync, existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const readme = `${root}README.md`;
const kept = `${root}dist/README.md`;

/** The page of the package, as npm will show it: its relative links lead to the repository. */
function packageReadme() {
  const { repository } = JSON.parse(readFileSync(`${root}package.json`, 'utf8'));
  const address = String(repository.url).replace(/^git\+|\.git$/g, '');
  return readFileSync(`${root}docs/npm-readme.md`, 'utf8').replace(/\]\((?!https?:|#)([^)]+)\)/g, (_, link) => {
    const path = new URL(link, 'file:///docs/').pathname.slice(1);
    const [, hash = ''] = String(link).split('#');
    return `](${address}/blob/main/${path}${hash && `#${hash}`})`;
  });
}

if (existsSync(kept)) renameSync(kept, readme);
if (process.argv[2] === 'put') {
  mkdirSync(`${root}dist`, { recursive: true });
  copyFileSync(readme, kept);
  writeFileSync(readme, packageReadme());
}
