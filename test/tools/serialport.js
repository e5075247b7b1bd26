/**
 * Replaces `serialport` in tests, because this project does not run its install script: a virtual timer is behind each
 * port except one.
 */
export const SERIALPORT = `import { Duplex } from 'node:stream';
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
    const options = { '/dev/rounds': { quirks: { timeStep: 10 } }, '/dev/slow': { latency: 100 } };
    const timer = new VirtualTimer(options[path]);
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
