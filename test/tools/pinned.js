// Runs a tool of pinned/: `node test/tools/pinned.js typedoc ...`. It is installed from the lockfile there, and again
// when that has changed. These tools need another TypeScript than the project.

import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, statSync } from 'node:fs';
import { delimiter } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

const folder = fileURLToPath(new URL('pinned/', import.meta.url));
const [tool = '', ...args] = process.argv.slice(2);

const installed = `${folder}node_modules/.package-lock.json`;
if (!existsSync(installed) || statSync(installed).mtimeMs < statSync(`${folder}package-lock.json`).mtimeMs) {
  execFileSync('npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], { cwd: folder, stdio: 'inherit' });
}
const { PATH: before = '' } = process.env;
const PATH = `${folder}node_modules/.bin${delimiter}${before}`;
const { status } = spawnSync(tool, args, { stdio: 'inherit', env: { ...process.env, PATH } });
process.exitCode = status ?? 1;
