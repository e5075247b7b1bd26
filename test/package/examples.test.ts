import { copyFileSync, mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import { firstContent } from '../../src/simulator/index.js';
import { B536 } from '../protocol/vectors.js';
import { Consumer, root } from '../tools/pack.js';

/**
 * What stands in for `serialport` here, whose install script this project does without: a virtual timer behind each
 * port but one.
 */
const SERIALPORT = `import { Duplex } from 'node:stream';
import { VirtualTimer } from 'sidus-timer/simulator';

export class SerialPort extends Duplex {
  static list = async () => [{ path: '/dev/timer', manufacturer: 'Nobody' }, { path: '/dev/asleep' }];
  isOpen = false;
  #options;
  #writer;
  constructor(options) {
    super();
    this.#options = options;
  }
  open(done) {
    const { path, baudRate, autoOpen } = this.#options;
    if (autoOpen !== false || baudRate !== 9600) throw new Error('opened in another way');
    if (path === '/dev/none') return done(new Error('No such file or directory, cannot open /dev/none'));
    this.isOpen = true;
    const timer = new VirtualTimer();
    if (path === '/dev/asleep') timer.core.sleep();
    timer.core.memory = 2;
    timer.core.onAnswer = ({ name }) => name === 'SETMEMORY' && process.stderr.write(\`memory \${timer.core.memory}\\n\`);
    this.#writer = timer.writable.getWriter();
    void timer.readable.pipeTo(new WritableStream({ write: (bytes) => void this.push(Buffer.from(bytes)) }));
    done(null);
  }
  close(done) {
    process.stderr.write('closed\\n');
    this.isOpen = false;
    done(null);
  }
  _read() {}
  _write(bytes, _, done) {
    this.#writer.write(Uint8Array.from(bytes)).then(() => done(), done);
  }
}
`;
const SERIALPORT_TYPES = `import type { Duplex } from 'node:stream';
export class SerialPort extends Duplex {
  static list(): Promise<{ path: string; manufacturer: string | undefined }[]>;
  constructor(options: { path: string; baudRate: number; autoOpen?: boolean });
  readonly isOpen: boolean;
  open(done?: (error: Error | null) => void): void;
  close(done?: (error: Error | null) => void): void;
}
`;

describe('the backup program for Node', () => {
  let consumer: Consumer;
  beforeAll(async () => {
    consumer = await Consumer.create();
    mkdirSync(join(consumer.folder, 'node_modules/serialport'), { recursive: true });
    consumer.write('node_modules/serialport/package.json', '{ "type": "module", "exports": "./index.js" }');
    consumer.write('node_modules/serialport/index.js', SERIALPORT);
    consumer.write('node_modules/serialport/index.d.ts', SERIALPORT_TYPES);
    consumer.link('@types');
    for (const file of ['backup.js', 'package.json', 'tsconfig.json']) {
      copyFileSync(join(root, 'examples/node-backup', file), join(consumer.folder, file));
    }
  });

  const backup = (...args: string[]) => consumer.tell(process.execPath, 'backup.js', ...args);
  const written = (file: string) =>
    JSON.parse(readFileSync(join(consumer.folder, file), 'utf8')) as { memories: object[] };

  it('compiles', () => {
    expect(consumer.tell(process.execPath, join(root, 'node_modules/typescript/bin/tsc'), '-p', '.')).toEqual({
      code: 0,
      said: '',
      complained: '',
    });
  });

  it('lists the ports', () => {
    expect(backup()).toMatchObject({ code: 0, said: expect.stringMatching(/^\/dev\/timer Nobody\n\/dev\/asleep \n/) });
  });

  it('writes the current memory to a file, and changes nothing', () => {
    expect(backup('/dev/timer', 'timer.json')).toEqual({
      code: 0,
      said: 'B 536: 1 of 4 memories are in timer.json.\n',
      complained: 'closed\n',
    });
    expect(written('timer.json')).toMatchObject({
      timer: B536,
      memories: [{ memory: 2, ...firstContent(B536, 2), idleThrottle: null }],
    });
  });

  it('writes all memories, and goes back to the one that was current', () => {
    expect(backup('/dev/timer', 'all.json', '--all')).toEqual({
      code: 0,
      said: 'B 536: 4 of 4 memories are in all.json.\n',
      complained: 'memory 0\nmemory 1\nmemory 3\nmemory 2\nclosed\n',
    });
    const { memories } = written('all.json');
    expect(memories).toEqual(
      [2, 0, 1, 3].map((memory) => expect.objectContaining({ memory, ...firstContent(B536, memory) })),
    );
  });

  it('overwrites no backup', () => {
    consumer.write('there.json', 'precious');
    expect(backup('/dev/timer', 'there.json')).toEqual({
      code: 1,
      said: '',
      complained: 'there.json is there already.\n',
    });
    expect(readFileSync(join(consumer.folder, 'there.json'), 'utf8')).toBe('precious');
  });

  it('says what went wrong, by code where there is one, and lets go of the port', () => {
    expect(backup('/dev/none', 'none.json')).toMatchObject({
      code: 1,
      complained: expect.stringContaining('No such file'),
    });
    expect(backup('/dev/asleep', 'asleep.json')).toMatchObject({
      code: 1,
      complained: expect.stringMatching(/^closed\n.*\(no-answer\)\n$/),
    });
  });
});

describe('the tests of a page that uses Web Serial', () => {
  it('pass in Vitest, on the mock port', async () => {
    const consumer = await Consumer.create();
    consumer.link('vitest');
    for (const file of ['thermometer.js', 'thermometer.test.js']) {
      copyFileSync(join(root, 'examples/mock-port', file), join(consumer.folder, file));
    }
    const vitest = join(root, 'node_modules/vitest/vitest.mjs');
    const { said } = consumer.tell(process.execPath, vitest, 'run', '--reporter=json', '--root', consumer.folder);
    expect(JSON.parse(said)).toMatchObject({ numTotalTests: 3, numPassedTests: 3 });
  });
});
