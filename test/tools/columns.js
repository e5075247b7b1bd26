// Holds comments to 120 columns, which the formatter leaves alone. Part of `npm run lint`. The prose of the docs is
// held by test/docs.test.ts.

import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const COLUMNS = 120;
const root = new URL('../../', import.meta.url);

/**
 * The lines of comments that are too long. A line with only an address may be longer.
 * @param {string} text the content of a file
 * @returns {number[]} their numbers, from 1
 */
export function longComments(text) {
  return text.split('\n').flatMap((line, index) => {
    const [, comment] = /^\s*(?:\/\/|\/?\*|\{\/\*|#)\s*(.*)$/.exec(line) ?? [];
    if (comment === undefined || line.length <= COLUMNS) return [];
    return /^\S*:\/\/\S*$/.test(comment) ? [] : [index + 1];
  });
}

/** All files of the project that can have comments. */
function files() {
  const inFolders = ['src', 'test', 'examples', 'public'].flatMap((folder) =>
    readdirSync(new URL(folder, root), { recursive: true, encoding: 'utf8' }).map((file) => `${folder}/${file}`),
  );
  return [...inFolders, ...readdirSync(root)].filter(
    (file) => /\.(?:[cm]?[jt]sx?|css|py|sh)$/.test(file) && !file.includes('node_modules'),
  );
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  for (const file of files()) {
    for (const line of longComments(readFileSync(new URL(file, root), 'utf8'))) {
      console.error(`${file}:${line}: a comment of more than ${COLUMNS} columns`);
      process.exitCode = 1;
    }
  }
}
