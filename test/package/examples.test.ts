import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { copyFileSync, existsSync, mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import { parseLibraryFile } from '../../src/program/index.js';
import { firstContent } from '../../src/simulator/index.js';
import { B536 } from '../protocol/vectors.js';
import { Consumer, root } from '../tools/pack.js';
import { SERIALPORT } from '../tools/serialport.js';

const SERIALPORT_TYPES = `import type { Duplex } from 'node:stream';
export class SerialPort extends Duplex {
  static list(): Promise<{ path: string; manufacturer: string | undefined }[]>;
  constructor(options: { path: string; baudRate: number; autoOpen?: boolean });
  readonly isOpen: boolean;
  open(done?: (error: Error | null) => void): void;
  close(done?: (error: Error | null) => void): void;
}
`;

describe('the program for Node', () => {
  let consumer: Consumer;
  beforeAll(async () => {
    consumer = await Consumer.create();
    mkdirSync(join(consumer.folder, 'node_modules/serialport'), { recursive: true });
    consumer.write('node_modules/serialport/package.json', '{ "type": "module", "exports": "./index.js" }');
    consumer.write('node_modules/serialport/index.js', SERIALPORT);
    consumer.write('node_modules/serialport/index.d.ts', SERIALPORT_TYPES);
    consumer.link('@types');
    for (const file of ['timer.js', 'package.json', 'tsconfig.json']) {
      copyFileSync(join(root, 'examples/node-backup', file), join(consumer.folder, file));
    }
  });

  const tool = (...args: string[]) => consumer.tell(process.execPath, 'timer.js', ...args);
  const settingsIn = (file: string) =>
    parseLibraryFile(readFileSync(join(consumer.folder, file), 'utf8')).library.settings;

  it('compiles', () => {
    expect(consumer.tell(process.execPath, join(root, 'node_modules/typescript/bin/tsc'), '-p', '.')).toEqual({
      code: 0,
      said: '',
      complained: '',
    });
  });

  it('lists the ports', () => {
    expect(tool()).toMatchObject({ code: 0, said: expect.stringMatching(/^\/dev\/timer Nobody\n\/dev\/asleep \n/) });
  });

  it('shows what the current memory holds, and changes nothing', () => {
    const { code, said, complained } = tool('/dev/timer');
    expect([code, complained]).toEqual([0, 'closed\n']);
    expect(said.split('\n').slice(0, 3)).toEqual([
      'B 536, memory M3',
      'Slot         time/s   S1   S2   S3',
      'Start                 15   15   15',
    ]);
    expect(said).toMatch(/\nDT +\d+\.00( +\d+){3}\n$/);
  });

  it('sets DT, and says verified only when it was', () => {
    expect(tool('/dev/timer', 'dt', '180')).toEqual({ code: 0, said: 'Verified.\n', complained: 'closed\n' });
    expect(tool('/dev/timer', 'dt', '20')).toMatchObject({
      code: 0,
      said: 'warning: DT is shorter than 60.00 s.\nVerified.\n',
    });
    expect(tool('/dev/rounds', 'dt', '20.55')).toMatchObject({
      code: 3,
      said: expect.stringMatching(/wanted 2055, the timer holds 2050\nNot verified: differs\.\n$/),
    });
    for (const wrong of ['655.36', '1e3', '0.123', 'long']) {
      expect(tool('/dev/timer', 'dt', wrong), wrong).toMatchObject({
        code: 1,
        complained: expect.stringContaining('655.35'),
      });
    }
  });

  it('writes the current memory to a file that the page opens, too', () => {
    expect(tool('/dev/timer', 'backup', 'timer.json')).toEqual({
      code: 0,
      said: 'B 536: 1 of 4 memories are in timer.json.\n',
      complained: 'closed\n',
    });
    expect(settingsIn('timer.json')).toMatchObject([
      { name: 'M3', program: { identity: B536, memory: 2, ...firstContent(B536, 2), idleThrottle: null } },
    ]);
  });

  it('writes all memories, goes back to the one that was current, and restores them', () => {
    expect(tool('/dev/timer', 'backup', 'all.json', '--all')).toEqual({
      code: 0,
      said: 'B 536: 4 of 4 memories are in all.json.\n',
      complained: 'memory 0\nmemory 1\nmemory 2\nmemory 3\nmemory 2\nclosed\n',
    });
    const programs = settingsIn('all.json').map(({ program }) => program);
    expect([...programs].sort((a, b) => Number(a.memory) - Number(b.memory))).toEqual(
      [0, 1, 2, 3].map((memory) => expect.objectContaining({ memory, ...firstContent(B536, memory) })),
    );
    const edited = readFileSync(join(consumer.folder, 'all.json'), 'utf8').replace('"time": "1.00"', '"time": "1.10"');
    consumer.write('edited.json', edited);
    expect(tool('/dev/timer', 'restore', 'edited.json')).toMatchObject({
      code: 0,
      said: expect.stringMatching(/^(M\d: Verified\.\n){4}$/),
    });
  });

  it('overwrites no backup, and restores nothing from a file that is no backup', () => {
    consumer.write('there.json', 'precious');
    expect(tool('/dev/timer', 'backup', 'there.json')).toMatchObject({ code: 1, said: '' });
    expect(readFileSync(join(consumer.folder, 'there.json'), 'utf8')).toBe('precious');
    expect(tool('/dev/timer', 'restore', 'there.json')).toMatchObject({ code: 1, said: '' });
  });

  it('is stopped by Ctrl+C after the request in progress, and releases the port', async () => {
    const args = ['timer.js', '/dev/slow', 'backup', 'slow.json', '--all'];
    const running = spawn(process.execPath, args, { cwd: consumer.folder, stdio: ['ignore', 'ignore', 'pipe'] });
    let complained = '';
    running.stderr.setEncoding('utf8').on('data', (text: string) => {
      complained += text;
      if (complained === 'memory 0\n') running.kill('SIGINT');
    });
    const [code] = (await once(running, 'close')) as [number];
    // The memory that was current is current again.
    expect([code, complained]).toEqual([130, expect.stringMatching(/^memory 0\nmemory 2\nclosed\n.*\(aborted\)\n$/)]);
    expect(existsSync(join(consumer.folder, 'slow.json'))).toBe(false);
  });

  it('says how to call it when an argument is wrong', () => {
    for (const wrong of [['dt', '-1'], ['--fly'], ['fly'], ['toString'], ['dt'], ['backup'], ['dt', '20', 'more']]) {
      expect(tool('/dev/timer', ...wrong), `timer.js ${wrong.join(' ')}`).toMatchObject({ code: 2, said: '' });
    }
  });

  it('says what went wrong, by code where there is one, and releases the port', () => {
    expect(tool('/dev/none')).toMatchObject({ code: 1, complained: expect.stringContaining('No such file') });
    expect(tool('/dev/asleep')).toMatchObject({
      code: 1,
      complained: expect.stringMatching(/^closed\n.*\(no-answer\)\n$/),
    });
  });
});

describe('the tests of a page that uses Web Serial', () => {
  it('pass in Vitest, on the mock port', async () => {
    const consumer = await Consumer.create();
    consumer.link('vitest');
    // In a clone the example lies inside a project that has a config of its own.
    consumer.write('vitest.config.js', 'export default { test: { include: [] } };');
    const example = join(consumer.folder, 'example');
    mkdirSync(example);
    for (const file of ['thermometer.js', 'thermometer.test.js', 'vitest.config.js']) {
      copyFileSync(join(root, 'examples/mock-port', file), join(example, file));
    }
    const vitest = join(root, 'node_modules/vitest/vitest.mjs');
    const { said } = consumer.tell(process.execPath, vitest, 'run', '--reporter=json', '--root', example);
    expect(JSON.parse(said)).toMatchObject({ numTotalTests: 4, numPassedTests: 4 });
  });
});

/** Plugs a virtual timer into a mock port, pulls the cable and puts it back; prints what the example shows. */
const LINKED = `import { MockSerial } from 'sidus-timer/mock-serial';
import { VirtualTimer } from 'sidus-timer/simulator';
import { watch } from './watch.js';

const serial = new MockSerial({ userActivation: true });
const heard = [];
let told = () => {};
const link = watch(serial, (line) => {
  heard.push(line);
  console.log(line);
  told();
});
const until = async (line) => {
  while (!heard.includes(line)) await new Promise((resolve) => (told = resolve));
  heard.length = 0;
};
await link.choose();
const port = serial.plug({ usbVendorId: 0x0403, usbProductId: 0x6001 });
const timer = new VirtualTimer({ identity: { timerClass: 'Q' } });
const pipe = async () => {
  const answers = timer.readable.getReader();
  for (let next = answers.read(); ; next = answers.read()) port.device.write((await next).value);
};
const asked = async () => {
  const writer = timer.writable.getWriter();
  for (;;) await writer.write(await port.device.read());
};
void pipe();
void asked();
serial.choose(port);
void link.choose();
await until('M1: DT 180.00 s');
serial.unplug(port);
await until('Unplugged: plug it in again');
serial.replug(port);
await until('M1: DT 180.00 s');
await link.stop();
process.exit();
`;

describe('the example of a link that lasts', () => {
  it('compiles, says why nothing was chosen, reads, and comes back after the cable was pulled', async () => {
    const consumer = await Consumer.create();
    copyFileSync(join(root, 'examples/link/watch.js'), join(consumer.folder, 'watch.js'));
    expect(consumer.compile({ allowJs: true, checkJs: true })).toBe('');
    consumer.write('linked.js', LINKED);
    const { code, said, complained } = consumer.tell(process.execPath, 'linked.js');
    expect([code, complained]).toEqual([0, '']);
    // On a slow machine the timer may be asked again in between.
    const lines = said.trim().split('\n');
    const wanted = [
      'Choose the adapter',
      'Not connected: nothing-chosen',
      'Choose the adapter',
      'Opening the port',
      'Asking at 9600 bits a second',
      'Class Q, firmware 536',
      'M1: DT 180.00 s',
      'Unplugged: plug it in again',
      'Opening the port',
      'Asking at 9600 bits a second',
      'Class Q, firmware 536',
      'M1: DT 180.00 s',
      'Closing the port',
      'Not connected',
    ];
    const inOrder = lines.reduce((found, line) => (line === wanted[found] ? found + 1 : found), 0);
    expect(wanted.slice(inOrder), said).toEqual([]);
    expect(lines.at(-1)).toBe('Not connected');
  });
});
