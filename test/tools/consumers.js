// Compiles programs of consumers against the packed package, with each TypeScript that must accept its types, and
// runs the example for Node with the real `serialport` on its mock binding. Needs the registry, so it is a part of
// `npm run check` and not of the tests.

import { execFileSync } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'sidus-consumers-'));

/** The oldest compiler that accepts the types, one of each year, and the project's own. */
const COMPILERS = ['5.0.4', '5.4.5', '5.7.3', '5.9.3', '6.0.3', '7.0.2'];
/** The package needs streams and AbortSignal; each of these has them. */
const SURROUNDINGS = [
  { name: 'DOM', lib: ['es2022', 'dom'], types: [] },
  { name: 'Node', lib: ['es2022'], types: ['node'] },
  // The default of TypeScript, with the types of Node installed.
  { name: 'DOM and Node', lib: ['es2022', 'dom'], types: ['node'] },
  { name: 'DOM, Node and the newest library', lib: ['esnext', 'dom', 'dom.iterable'], types: ['node'] },
];

/** What the package makes is bytes as the platform wants them. TypeScript 5.7 and later tell those from shared ones. */
const BYTES = `import { encodeFrame, frames, parseCapture, formatCapture } from 'sidus-timer/protocol';
import { MockSerial } from 'sidus-timer/mock-serial';
import { VirtualTimer } from 'sidus-timer/simulator';

export async function use(socket: WebSocket, stream: ReadableStream<Uint8Array>, plain: Uint8Array): Promise<void> {
  const device = new MockSerial().plug({}).device;
  const { value } = await new VirtualTimer().readable.getReader().read();
  const data: Uint8Array[] = [];
  for await (const frame of frames(stream)) data.push(frame.data);
  for await (const { data } of frames(new Response(new Blob()).body ?? [])) socket.send(data);
  const made = [encodeFrame(0x6b), await device.read(), value ?? encodeFrame(0x6b), ...parseCapture('').map((e) => e.bytes)];
  for (const bytes of made) {
    new Blob([bytes]);
    await crypto.subtle.digest('SHA-256', bytes);
    await fetch('/', { method: 'POST', body: bytes });
    socket.send(bytes);
  }
  formatCapture([{ time: 0, direction: 'in', bytes: plain }]);
}
`;

/** Listeners know the event and their object, as those of the platform do. What a link tells is typed, too. */
const EVENTS = `import { MockSerial } from 'sidus-timer/mock-serial';
import { type LinkState, TimerLink } from 'sidus-timer/serial';

const serial = new MockSerial();
const port = serial.plug();
serial.addEventListener('connect', function (event) { void this.getPorts().then(() => event.preventDefault()); });
port.addEventListener('disconnect', function ({ type }) { console.log(type, this.connected); }, { once: true });
port.removeEventListener('disconnect', async ({ type }) => console.log(type.length), true);
port.addEventListener('own', { handleEvent: ({ type }) => console.log(type.length) });
port.onconnect = function ({ type }) { console.log(type.length, this.device); };
// @ts-expect-error: such an event does not come
serial.addEventListener('connect', (event: Event & { data: string }) => event.data);
const state = ({ status }: LinkState): void => console.log(status);
new TimerLink({ serial, onState: state, onLine: ({ bytes, direction }) => console.log(bytes.length, direction) });
`;

/** For a project with the types of Node: its streams are a port. */
const NODE = `import { Duplex } from 'node:stream';
import { COMMANDS, decodeReply, TimerClient } from 'sidus-timer';

export async function times(stream: Duplex): Promise<readonly number[]> {
  const timer = new TimerClient(Duplex.toWeb(stream), { baudRate: 9600 });
  const reply = decodeReply({ code: COMMANDS.GETMEMORY.reply, data: Uint8Array.of(1) }, { pending: 'GETMEMORY' });
  const memory: number | null = reply.memory;
  console.log(memory);
  const { times } = await timer.request({ name: 'GETTIMERS' });
  await timer[Symbol.asyncDispose]();
  return times;
}
`;

/**
 * @param {string} where
 * @param {string} program
 * @param {string[]} args
 */
function run(where, program, ...args) {
  try {
    return execFileSync(program, args, { cwd: where, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
  } catch (error) {
    const { stdout = '', stderr = '' } = /** @type {{ stdout?: string, stderr?: string }} */ (error);
    throw new Error(`${program} ${args.join(' ')}\n${stdout}${stderr}`);
  }
}

/** @param {string} where @param {string[]} args */
const npm = (where, ...args) => run(where, 'npm', ...args, '--ignore-scripts', '--no-audit', '--no-fund');

/** A program that uses every entry of the package, with all exports. */
function everything() {
  const { exports } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  const entries = Object.keys(exports).filter((entry) => !entry.endsWith('.json'));
  const readme = readFileSync(join(root, 'README.md'), 'utf8');
  const examples = [...readme.matchAll(/```ts\n(.*?)```/gs)].map(([, code]) => code);
  const lines = entries.map((entry, index) =>
    entry.endsWith('.js')
      ? `import 'sidus-timer${entry.slice(1)}';\nexport const page = new SidusMockSerial.MockSerial();`
      : `export * as entry${index} from 'sidus-timer${entry.slice(1)}';`,
  );
  return [lines.join('\n'), ...examples];
}

/** @param {string} tarball */
function compile(tarball) {
  const where = join(folder, 'compile');
  cpSync(join(root, 'examples/node-backup/.npmrc'), join(where, '.npmrc'));
  writeFileSync(join(where, 'package.json'), '{ "type": "module" }');
  for (const [index, code] of everything().entries()) writeFileSync(join(where, `program-${index}.ts`), String(code));
  const typescripts = COMPILERS.map((version) => `typescript-${version}@npm:typescript@${version}`);
  npm(where, 'install', tarball, '@types/node@20.19.43', ...typescripts);
  writeFileSync(join(where, 'events.ts'), EVENTS);
  for (const { name, lib, types } of SURROUNDINGS) {
    const options = { strict: true, noEmit: true, skipLibCheck: false, module: 'nodenext', target: 'es2022' };
    const compilerOptions = { ...options, lib, types, exactOptionalPropertyTypes: true };
    writeFileSync(join(where, 'tsconfig.json'), JSON.stringify({ compilerOptions, include: ['*.ts'] }));
    writeFileSync(join(where, 'node.ts'), types.includes('node') ? NODE : '');
    writeFileSync(join(where, 'bytes.ts'), lib.includes('dom') ? BYTES : '');
    for (const version of COMPILERS) {
      run(where, process.execPath, `node_modules/typescript-${version}/bin/tsc`, '-p', '.');
      console.log(`TypeScript ${version} accepts the types, with ${name}.`);
    }
  }
}

/** Puts serialport's mock binding, with a virtual timer, in place of the one that needs hardware. */
const MOCK = `const { MockBinding, MockPortBinding } = require('@serialport/binding-mock');
const path = require.resolve('@serialport/bindings-cpp');
require.cache[path] = { id: path, filename: path, loaded: true, exports: { autoDetect: () => MockBinding } };
MockBinding.createPort('/dev/timer', { manufacturer: 'Nobody' });
const timer = import('sidus-timer/simulator').then(({ VirtualTimer }) => new VirtualTimer());
const { write } = MockPortBinding.prototype;
MockPortBinding.prototype.write = async function (bytes) {
  await write.call(this, bytes);
  const { readable, writable } = await timer;
  if (!readable.locked) void readable.pipeTo(new WritableStream({ write: (reply) => this.emitData(reply) }));
  const writer = writable.getWriter();
  await writer.write(Uint8Array.from(bytes));
  writer.releaseLock();
};
`;

/** @param {string} tarball */
function backUp(tarball) {
  const where = join(folder, 'node-backup');
  cpSync(join(root, 'examples/node-backup'), where, {
    recursive: true,
    filter: (path) => !path.endsWith('node_modules'),
  });
  const description = JSON.parse(readFileSync(join(where, 'package.json'), 'utf8'));
  description.dependencies['sidus-timer'] = `file:${tarball}`;
  writeFileSync(join(where, 'package.json'), JSON.stringify(description));
  npm(where, 'install');
  run(where, 'npm', 'run', 'typecheck');
  writeFileSync(join(where, 'mock.cjs'), MOCK);
  const said = run(
    where,
    process.execPath,
    '--require',
    './mock.cjs',
    'timer.js',
    '/dev/timer',
    'backup',
    'timer.json',
    '--all',
  );
  const { settings } = JSON.parse(readFileSync(join(where, 'timer.json'), 'utf8'));
  if (settings.length !== 4 || settings[3].program.slots[10].time !== '270.00')
    throw new Error(`Not backed up: ${said}`);
  console.log(`The program for Node works with serialport: ${said.trim()}`);
}

try {
  const [{ filename }] = JSON.parse(run(root, 'npm', 'pack', '--json', '--pack-destination', folder));
  const tarball = join(folder, filename);
  compile(tarball);
  backUp(tarball);
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
} finally {
  rmSync(folder, { recursive: true, force: true });
}
