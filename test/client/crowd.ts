import type { BytePort } from '../../src/client/index.js';
import { FrameDecoder } from '../../src/protocol/index.js';
import type { VirtualTimer } from '../../src/simulator/index.js';

/** When an unexpected frame comes: before the request reaches the timer, or after the timer's reply. */
export type Moment = 'before' | 'after';

/** A port with a second talker in its beam, at the requests that a test names. */
export interface Crowd extends BytePort {
  /** What else comes at this request, counted from 0 over all requests; nothing by default. */
  stray: (index: number, code: number, moment: Moment) => Uint8Array | undefined;
  /** Sends bytes at once. */
  say(bytes: Uint8Array): void;
}

/** Stands between a client and a timer that answers at once. */
export function crowd(timer: VirtualTimer): Crowd {
  const toTimer = timer.writable.getWriter();
  const requests = new FrameDecoder();
  let count = 0;
  let controller: ReadableStreamDefaultController<Uint8Array> | undefined;
  /** What follows the timer's next reply. */
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
