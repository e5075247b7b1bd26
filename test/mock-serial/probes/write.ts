import { differs, opened, type Probe, probe } from './lab.js';

const COUNTS_CHUNKS = 'Chromium counts one chunk, the standard as many bytes as the buffer holds';

export const WRITE: readonly Probe[] = [
  opened('bytes reach the device in order', '1 2 3', async ({ writer, receive, log }) => {
    const one = writer();
    for (const byte of [1, 2, 3]) void one.write(Uint8Array.of(byte));
    while (log.length < 3) log.push(...(await receive(1)));
  }),
  opened('8000 bytes', 'true', async ({ writer, receive }) => {
    void writer().write(Uint8Array.from({ length: 8000 }, (_, index) => index % 251));
    return (await receive(8000)).every((byte, index) => byte === index % 251);
  }),
  opened('buffers, and views of a part', '1 2 3 4 5 6 7 8', async ({ writer, receive, log }) => {
    const one = writer();
    void one.write(Uint8Array.of(1, 2).buffer);
    void one.write(new Uint8Array(Uint8Array.of(0, 3, 4, 0).buffer, 1, 2));
    void one.write(new DataView(Uint8Array.of(0, 5, 6).buffer, 1));
    void one.write(Uint16Array.of(0x0807));
    while (log.length < 8) log.push(...(await receive(1)));
  }),
  probe('an empty array', 'done', ({ wrote }) => wrote(new Uint8Array())),
  probe('a detached array', 'done', ({ wrote }) => {
    const bytes = Uint8Array.of(1, 2);
    structuredClone(bytes.buffer, { transfer: [bytes.buffer] });
    return wrote(bytes);
  }),
  probe('refused: text', 'TypeError', ({ wrote }) => wrote('text')),
  probe('refused: an array of numbers', 'TypeError', ({ wrote }) => wrote([1, 2])),
  probe('refused: nothing at all', 'TypeError', ({ wrote }) => wrote(undefined)),
  probe('refused: null', 'TypeError', ({ wrote }) => wrote(null)),
  probe('refused: what only says that it is a buffer', 'TypeError', ({ wrote }) =>
    wrote({ [Symbol.toStringTag]: 'ArrayBuffer', byteLength: 2 }),
  ),
  probe('refused: a resizable buffer', 'TypeError', ({ wrote }) =>
    wrote(Reflect.construct(ArrayBuffer, [4, { maxByteLength: 8 }])),
  ),
  probe('refused: a view of one', 'TypeError', ({ wrote }) =>
    wrote(new Uint8Array(Reflect.construct(ArrayBuffer, [4, { maxByteLength: 8 }]))),
  ),
  probe('refused: shared memory', 'TypeError', ({ wrote }) =>
    wrote(new WebAssembly.Memory({ initial: 1, maximum: 1, shared: true }).buffer),
  ),
  probe('refused: a view of it', 'TypeError', ({ wrote }) =>
    wrote(new Uint8Array(new WebAssembly.Memory({ initial: 1, maximum: 1, shared: true }).buffer)),
  ),
  opened(
    'after a refused chunk writable stays broken, and close() waits for ever',
    'TypeError TypeError true pending InvalidStateError',
    async ({ port, writer, how }) => {
      const { writable } = port;
      const one = writer();
      const said = [await how(one.write('text')), await how(one.write(Uint8Array.of(1))), port.writable === writable];
      one.releaseLock();
      return [...said, await how(port.close()), await how(port.open({ baudRate: 9600 }))];
    },
  ),
  opened('a refused chunk after another', 'done TypeError TypeError [1]', async ({ writer, receive, how }) => {
    const one = writer();
    const said = [Uint8Array.of(1), 'text', Uint8Array.of(2)].map((chunk) => how(one.write(chunk)));
    return [...(await Promise.all(said)), await receive(1)];
  }),
  opened(
    'a chunk is copied in write(), once the stream has begun',
    '[9,9,9] [1,2,3]',
    async ({ writer, receive, log }) => {
      const one = writer();
      const bytes = new Uint8Array(3);
      for (const _ of ['first', 'second']) {
        bytes.set([1, 2, 3]);
        const written = one.write(bytes);
        bytes.fill(9);
        log.push(await receive(3));
        await written;
      }
    },
  ),
  opened('a chunk that is changed while another is written', '1 9', async ({ writer, receive, log }) => {
    const one = writer();
    const bytes = Uint8Array.of(2);
    void one.write(Uint8Array.of(1));
    void one.write(bytes);
    bytes[0] = 9;
    while (log.length < 2) log.push(...(await receive(1)));
  }),
  opened('how much the stream wants', differs(COUNTS_CHUNKS, '255 252', '1 0'), ({ writer }) => {
    const one = writer();
    const before = one.desiredSize;
    void one.write(Uint8Array.of(1, 2, 3));
    return [before, one.desiredSize];
  }),
  opened('close() of a writer: all bytes, then a new stream', 'done [1,2] done false', async (lab) => {
    const { writable } = lab.port;
    const one = lab.writer();
    void one.write(Uint8Array.of(1, 2));
    const received = lab.receive(2);
    return [await lab.how(one.close()), await received, await lab.how(one.closed), lab.port.writable === writable];
  }),
  opened('abort(): a new stream', 'done mine mine false [2]', async ({ port, writer, receive, how }) => {
    const { writable } = port;
    const one = writer();
    const said = [await how(one.abort('mine')), await how(one.closed), await how(one.write(Uint8Array.of(1)))];
    await writer().write(Uint8Array.of(2));
    return [...said, port.writable === writable, await receive(1)];
  }),
  opened('close() of the port while abort() goes on', 'done done null', async ({ port, writer, how }) => {
    const one = writer();
    one.write(new Uint8Array(1024)).catch(() => {});
    const aborted = how(one.abort());
    one.releaseLock();
    return [await how(port.close()), await aborted, port.writable];
  }),
  opened('close() of the port while a writer closes', 'done InvalidStateError', async ({ port, writer, how }) => {
    const one = writer();
    const closed = how(one.close());
    one.releaseLock();
    return [await how(port.close()), await closed];
  }),
  opened('a pipe, and its end', '[72,105] done false', async ({ port, receive, how }) => {
    const encoder = new TextEncoderStream();
    const piped = encoder.readable.pipeTo(port.writable as unknown as WritableStream<Uint8Array>);
    const one = encoder.writable.getWriter();
    void one.write('Hi');
    const received = await receive(2);
    await one.close();
    return [received, await how(piped), port.writable?.locked];
  }),
];
