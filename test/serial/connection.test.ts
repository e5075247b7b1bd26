import { describe, expect, it } from 'vitest';
import type { LineEntry } from '../../src/client/index.js';
import { type ConnectOptions, connect, type SerialPortLike } from '../../src/serial/index.js';
import { B536, CAPTURED_POSITIONS } from '../protocol/vectors.js';
import { answerNonsense, canBeOpened, failure, serialBench, type TimerOptions } from './bench.js';

/** Connects on a clock that is turned by hand. */
async function connected(timer: TimerOptions = {}, options: ConnectOptions = {}) {
  const bench = serialBench(timer);
  const { clock, port } = bench;
  const connection = await clock.run(connect(port, { clock, ...options }));
  return { ...bench, connection };
}

describe('connect', () => {
  it('opens with 9600 bits a second, 8N1 and a buffer of 16 KiB', async () => {
    const { port } = await connected();
    expect(port.device.opened).toEqual({
      baudRate: 9600,
      dataBits: 8,
      stopBits: 1,
      parity: 'none',
      bufferSize: 16384,
      flowControl: 'none',
    });
  });

  it('opens at another rate if asked to', async () => {
    const { port } = await connected({}, { baudRate: 57600 });
    expect(port.device.opened).toMatchObject({ baudRate: 57600 });
  });

  it('asks the timer what it is, and shows the bytes of that', async () => {
    const line: LineEntry[] = [];
    const { connection } = await connected({}, { onLine: (entry) => line.push(entry) });
    expect(connection.identity).toEqual(B536);
    expect(connection.client.identity).toEqual(B536);
    expect(line.map(({ direction }) => direction)).toEqual(['out', 'in']);
  });

  it('reads what the timer holds', async () => {
    const { clock, connection } = await connected();
    const program = await clock.run(connection.client.readProgram());
    expect(program.positions).toEqual([CAPTURED_POSITIONS, CAPTURED_POSITIONS, CAPTURED_POSITIONS]);
  });

  it('reads the same over a line that takes its time', async () => {
    const { clock, connection } = await connected({ plug: { timing: true, latency: 20, chunks: [1, 7, 3] } });
    const begin = clock.now();
    await clock.run(connection.client.readProgram());
    expect(clock.now() - begin).toBeGreaterThan(100);
  });

  it('says that the port is busy when another program holds it, and leaves it alone', async () => {
    const { clock, port } = serialBench({ plug: { busy: true } });
    expect(await failure(clock.run(connect(port, { clock })))).toMatchObject({
      name: 'ConnectionError',
      code: 'busy',
      cause: { name: 'NetworkError' },
    });
    port.device.busy = false;
    expect((await clock.run(connect(port, { clock }))).identity).toEqual(B536);
  });

  it('says that the adapter is not plugged in', async () => {
    const { clock, port, adapter } = serialBench();
    adapter.unplug();
    expect(await failure(clock.run(connect(port, { clock })))).toMatchObject({ code: 'unplugged' });
  });

  it('says that nobody answers, within three seconds, and closes the port again', async () => {
    const { clock, port, timer } = serialBench();
    timer.core.sleep();
    const begin = clock.now();
    expect(await failure(clock.run(connect(port, { clock })))).toMatchObject({
      code: 'no-answer',
      cause: { name: 'TimerError' },
    });
    expect(clock.now() - begin).toBeLessThanOrEqual(3000);
    expect(port.device.opened).toBeNull();
    timer.core.press();
    expect((await clock.run(connect(port, { clock }))).identity).toEqual(B536);
  });

  it('says that what answered is no timer, and closes the port again', async () => {
    const { clock, serial } = serialBench();
    const port = serial.plug();
    void answerNonsense(port);
    expect(await failure(clock.run(connect(port, { clock })))).toMatchObject({ code: 'bad-reply' });
    expect(await canBeOpened(port)).toBe(true);
  });

  it('says that the port was lost when the plug is pulled before the timer has said what it is', async () => {
    const { clock, port, adapter } = serialBench();
    adapter.unplugAfter(5);
    expect(await failure(clock.run(connect(port, { clock })))).toMatchObject({ code: 'lost' });
    adapter.replug();
    expect(await canBeOpened(port)).toBe(true);
  });

  it('stops when asked to, and closes the port again', async () => {
    const { clock, port, timer } = serialBench();
    timer.core.sleep();
    const stop = new AbortController();
    const connecting = failure(connect(port, { clock, signal: stop.signal }));
    await clock.advance(100);
    stop.abort();
    expect(await clock.run(connecting)).toMatchObject({ name: 'TimerError', code: 'aborted' });
    expect(await canBeOpened(port)).toBe(true);
  });

  it('closes a port that never takes the bytes it is given', async () => {
    const { clock, port } = serialBench();
    const stuck = new WritableStream<Uint8Array>({ write: () => new Promise(() => {}) });
    let closed = false;
    const wedged: SerialPortLike = {
      get readable() {
        return port.readable;
      },
      writable: stuck,
      open: (options) => port.open(options),
      close: async () => {
        // As the standard has it.
        if (stuck.locked) throw new TypeError('Cannot close the port while its writable is locked.');
        await port.close();
        closed = true;
      },
      getInfo: () => port.getInfo(),
      addEventListener: (type, listener) => port.addEventListener(type, listener),
      removeEventListener: (type, listener) => port.removeEventListener(type, listener),
    };
    expect(await failure(clock.run(connect(wedged, { clock })))).toMatchObject({ code: 'no-answer' });
    expect(closed, 'the port is closed').toBe(true);
  });
});

describe('close', () => {
  it('releases both locks and closes the port, which can be opened again at once', async () => {
    const { connection, port, clock } = await connected();
    const { readable, writable } = port;
    await connection.close();
    expect([readable?.locked, writable?.locked]).toEqual([false, false]);
    expect(port.device.opened).toBeNull();
    expect((await clock.run(connect(port, { clock }))).identity).toEqual(B536);
  });

  it('lets the request under way come to its end', async () => {
    const { connection, port, clock, timer } = await connected({ plug: { timing: true } });
    const reading = failure(connection.client.readProgram());
    await clock.advance(5);
    await clock.run(connection.close());
    expect(await reading).toMatchObject({ code: 'closed' });
    expect(timer.core.answered.map(({ name }) => name)).toEqual(['GETSWVER', 'GETMEMORY']);
    expect(port.device.opened).toBeNull();
  });

  it('is not taken for a loss', async () => {
    const { connection, clock, adapter } = await connected();
    let lost = false;
    void connection.lost.then(() => {
      lost = true;
    });
    await connection.close();
    adapter.unplug();
    await clock.advance(1000);
    expect(lost).toBe(false);
  });

  it('can be called twice, and after the loss of the port', async () => {
    const { connection, adapter } = await connected();
    adapter.unplug();
    await connection.lost;
    await connection.close();
    await connection.close();
    adapter.replug();
    expect(await canBeOpened(adapter.port)).toBe(true);
  });
});

describe('a lost port', () => {
  it('is noticed while nothing is asked', async () => {
    const { connection, adapter } = await connected();
    adapter.unplug();
    expect(await connection.lost).toMatchObject({ name: 'ConnectionError', code: 'lost' });
  });

  it.each([1, 8, 30, 60, 80])('is noticed %i bytes into a read, which says so', async (bytes) => {
    const { connection, clock, adapter } = await connected();
    adapter.unplugAfter(bytes);
    const reading = failure(connection.client.readProgram());
    expect(await clock.run(reading)).toMatchObject({ name: 'TimerError', code: 'port-lost' });
    expect(await connection.lost).toMatchObject({ code: 'lost' });
  });

  it('is noticed when the stream fails although the browser says nothing of the plug', async () => {
    const { connection, port } = await connected();
    port.device.error('lost');
    expect(await connection.lost).toMatchObject({ code: 'lost', cause: { code: 'port-lost' } });
  });

  it('is noticed when the browser says so although the stream has not failed', async () => {
    const { connection, port } = await connected();
    port.dispatchEvent(new Event('disconnect', { bubbles: true }));
    expect(await connection.lost).toMatchObject({ code: 'lost' });
  });

  it('is noticed when the site gives up its permission', async () => {
    const { connection, port } = await connected();
    await port.forget();
    expect(await connection.lost).toMatchObject({ code: 'lost' });
  });

  it('is noticed when writing fails', async () => {
    const { connection, port, clock } = await connected();
    port.device.failNextWrite('lost', 4);
    expect(await clock.run(failure(connection.client.readProgram()))).toMatchObject({ code: 'port-lost' });
    expect(await connection.lost).toMatchObject({ code: 'lost' });
  });

  it('can be connected again after plugging in, and is the same timer', async () => {
    const { connection, port, clock, adapter } = await connected();
    adapter.unplug();
    await connection.lost;
    await connection.close();
    adapter.replug();
    const again = await clock.run(connect(port, { clock }));
    expect(again.identity).toEqual(B536);
    expect((await clock.run(again.client.readProgram())).positions[2]).toEqual(CAPTURED_POSITIONS);
  });

  it('is told by the new connection alone once there is one', async () => {
    const { connection, port, clock, adapter } = await connected();
    await connection.close();
    const again = await clock.run(connect(port, { clock }));
    let told = 0;
    for (const { lost } of [connection, again]) void lost.then(() => told++);
    adapter.unplug();
    await again.lost;
    await clock.advance(1000);
    expect(told).toBe(1);
  });
});

describe('a disturbed line', () => {
  it.each(['framing', 'parity', 'break', 'overrun', 'system'] as const)(
    'reads to the end through a %s error in the middle',
    async (kind) => {
      const { connection, clock, port, adapter } = await connected({ plug: { timing: true } });
      adapter.after(60, () => port.device.error(kind));
      const program = await clock.run(connection.client.readProgram());
      expect(program.positions).toEqual([CAPTURED_POSITIONS, CAPTURED_POSITIONS, CAPTURED_POSITIONS]);
      expect(connection.client.damageSeen).toBe(true);
    },
  );

  it('reads to the end when bytes are lost, changed or doubled', async () => {
    for (const damage of [[], [0x55], [0x45, 0x45]]) {
      const toPage = (byte: number, index: number) => (index === 70 ? damage : [byte]);
      const { connection, clock } = await connected({ plug: { timing: true, fault: { toPage } } });
      const program = await clock.run(connection.client.readProgram());
      expect(program.positions, JSON.stringify(damage)).toEqual([
        CAPTURED_POSITIONS,
        CAPTURED_POSITIONS,
        CAPTURED_POSITIONS,
      ]);
    }
  });
});
