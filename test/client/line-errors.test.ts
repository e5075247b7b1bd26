import { describe, expect, it } from 'vitest';
import { type BytePort, TimerClient } from '../../src/client/index.js';
import { bench, contentOf } from './bench.js';

/** A port as Web Serial has it: its stream fails with an error of the line, and then there is a new one. */
class FailingPort implements BytePort {
  readable: ReadableStream<Uint8Array> | null = null;
  readonly writable: WritableStream<Uint8Array>;
  #controller: ReadableStreamDefaultController<Uint8Array> | undefined;

  constructor({ readable, writable }: { readable: ReadableStream<Uint8Array>; writable: WritableStream<Uint8Array> }) {
    this.writable = writable;
    this.#open();
    void readable.pipeTo(new WritableStream({ write: (bytes) => this.#controller?.enqueue(bytes) }));
  }

  fail(error: unknown, forGood = false): void {
    this.#controller?.error(error);
    if (forGood) this.readable = null;
    else this.#open();
  }

  #open(): void {
    this.readable = new ReadableStream({
      start: (controller) => {
        this.#controller = controller;
      },
    });
  }
}

describe('an error of the line', () => {
  it.each([
    ['FramingError', 'framing'],
    ['ParityError', 'parity'],
    ['BreakError', 'break'],
    ['BufferOverrunError', 'overrun'],
    ['UnknownError', 'other'],
  ] as const)('%s: reading goes on, and the error is reported as %s, and counted', async (name, kind) => {
    const { timer, clock, run, line } = bench();
    const port = new FailingPort(timer);
    const client = new TimerClient(port, { clock, onLine: (entry) => line.push(entry) });
    await run(client.identify());
    expect(client.lineErrors.size).toBe(0);
    for (let times = 1; times <= 2; times++) {
      timer.core.onAnswer = ({ name: asked }) => {
        timer.core.onAnswer = undefined;
        if (asked === 'GETMEMORY') port.fail(new DOMException('', name));
      };
      expect(await run(client.readProgram())).toEqual(contentOf(timer));
      expect([...client.lineErrors]).toEqual([[kind, times]]);
    }
    expect(client.damageSeen).toBe(true);
    const told = line.filter(({ error }) => error !== null);
    expect(told).toEqual(
      Array(2).fill({
        time: expect.any(Number),
        direction: 'in',
        bytes: new Uint8Array(0),
        frame: null,
        rejected: null,
        error: kind,
      }),
    );
    for (const { frame, rejected, error } of line) {
      expect([frame, rejected, error].filter((what) => what !== null)).toHaveLength(1);
    }
  });

  it('without a new stream after it is the loss of the port', async () => {
    const { timer, clock, run } = bench();
    const port = new FailingPort(timer);
    let lost: unknown;
    const client = new TimerClient(port, {
      clock,
      onLost: (error) => {
        lost = error;
      },
    });
    await run(client.identify());
    const cause = new DOMException('', 'NetworkError');
    port.fail(cause, true);
    await expect(run(client.readProgram())).rejects.toMatchObject({ code: 'port-lost', cause });
    expect(lost).toMatchObject({ code: 'port-lost' });
    expect(client.lineErrors.size).toBe(0);
  });

  it('is reported as other when the stream fails with something that is not an error', async () => {
    const { timer, clock, run } = bench();
    const port = new FailingPort(timer);
    const client = new TimerClient(port, { clock });
    await run(client.identify());
    port.fail(undefined);
    await run(client.readProgram());
    expect([...client.lineErrors]).toEqual([['other', 1]]);
  });
});
