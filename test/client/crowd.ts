import type { BytePort } from '../../src/client/index.js';
import { FrameDecoder } from '../../src/protocol/index.js';
import type { VirtualTimer } from '../../src/simulator/index.js';

/**
 * When a frame that nobody asked for comes: before the request is with the timer, or behind the timer's reply to it.
 */
export type Moment = 'before' | 'after';

/** A port into whose beam something else talks, at the requests that a test names. */
export interface Crowd extends BytePort {
  /** What else comes at this request, counted from 0 over all that went out; nothing by default. */
  stray: (index: number, code: number, moment: Moment) => Uint8Array | undefined;
  /** Says something at once. */
  say(bytes: Uint8Array): void;
}

/** Stands between a client and a timer that answers at once. */
export function crowd(timer: VirtualTimer): Crowd {
  const toTimer = timer.writable.getWriter();
  const requests = new FrameDecoder();
  let count = 0;
  let controller: ReadableStreamDefaultController<Uint8Array> | undefined;
  /** What follows the next reply of the timer. */
  let behind: Uint8Array | undefined;
  const say = (bytes: Uint8Array | undefined): void => {
    if (bytes) controller?.enqueue(bytes);
  };
  const port: Crowd = {
    stray: () => undefined,
    say,
    readable: new ReadableStream({
      start: (own) => {
        controller = own;
      },
    }),
    writable: new WritableStream({
      write: async (bytes) => {
        for (const { code } of requests.push(bytes)) {
          const index = count++;
          say(port.stray(index, code, 'before'));
          behind = port.stray(index, code, 'after');
        }
        await toTimer.write(bytes);
      },
    }),
  };
  void timer.readable.pipeTo(
    new WritableStream({
      write: (bytes) => {
        say(bytes);
        say(behind);
        behind = undefined;
      },
    }),
  );
  return port;
}
