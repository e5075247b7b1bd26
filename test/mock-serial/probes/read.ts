import { chromium, opened, type Probe, probe } from './lab.js';

export const READ: readonly Probe[] = [
  opened('bytes that came before', '1 2 3', async ({ send, reader, next }) => {
    await send(1, 2, 3);
    return next(reader());
  }),
  opened('every byte', 'true', async ({ send, reader }) => {
    const one = reader();
    const got: number[] = [];
    void send(...Array.from({ length: 255 }, (_, index) => 255 - index));
    while (got.length < 255) got.push(...((await one.read()).value ?? []));
    return got.every((byte, index) => byte === 255 - index);
  }),
  opened('nothing comes', 'pending', ({ reader, next }) => next(reader())),
  opened('two reads that wait are served in turn', '[1] [2]', async ({ send, reader }) => {
    const one = reader();
    const reads = [one.read(), one.read()];
    await send(1);
    await send(2);
    return (await Promise.all(reads)).map(({ value }) => [...(value ?? [])]);
  }),
  opened('a lock is released, and no byte is lost', 'TypeError [5]', async ({ send, reader, how, next }) => {
    const first = reader();
    const read = how(first.read());
    first.releaseLock();
    await send(5);
    return [await read, await next(reader())];
  }),
  opened('it is a byte stream, which reads into a part of a buffer', '[1,2,3] 4 10', async ({ port, send }) => {
    const one = port.readable?.getReader({ mode: 'byob' });
    await send(1, 2, 3);
    const { value } = (await one?.read(new Uint8Array(new ArrayBuffer(10), 4, 5))) ?? {};
    return [[...(value ?? [])], value?.byteOffset, value?.buffer.byteLength];
  }),
  opened('a reader with a buffer takes no more than that holds', '2 2 1', async ({ port, send, log }) => {
    await send(1, 2, 3, 4, 5);
    const one = port.readable?.getReader({ mode: 'byob' });
    for (const size of [2, 2, 2]) log.push((await one?.read(new Uint8Array(size)))?.value?.length);
  }),
  opened('a pipe, and its end', 'Hi done false done', async ({ port, send, how }) => {
    const decoder = new TextDecoderStream();
    const piped = port.readable?.pipeTo(decoder.writable as WritableStream<Uint8Array>);
    const one = decoder.readable.getReader();
    await send(72, 105);
    const { value } = await one.read();
    await one.cancel('done');
    return [value, await how(piped), port.readable?.locked, await how(port.close())];
  }),
  opened('more than the buffer holds, while a read waits', '300', async ({ send, reader }) => {
    const one = reader();
    const first = one.read();
    await send(...Array(300).fill(7));
    let got = (await first).value?.length ?? 0;
    while (got < 300) got += (await one.read()).value?.length ?? 0;
    return got;
  }),
  opened(
    'more than the buffer holds, while nobody reads',
    chromium('bufferNeverOverruns', '255 BufferOverrunError', '300'),
    async ({ send, reader, next }) => {
      await send(...Array(300).fill(7));
      const one = reader();
      let got = 0;
      while (got < 300) {
        const said = await next(one);
        if (!Array.isArray(said)) return [got, said];
        got += said.length;
      }
      return got;
    },
  ),
  opened('cancel() with nothing to read: readable is new after it', 'true false', async ({ port }) => {
    const { readable } = port;
    const cancelled = readable?.cancel();
    const during = port.readable === readable;
    await cancelled;
    return [during, port.readable === readable];
  }),
  opened('cancel() ends a read that waits', 'done end done', async ({ reader, next, how }) => {
    const one = reader();
    const read = next(one);
    return [await how(one.cancel()), await read, await how(one.closed)];
  }),
  opened('cancel() discards what had come; later bytes are read', '4', async ({ port, send, reader, next }) => {
    await send(1, 2, 3);
    await port.readable?.cancel();
    await send(4);
    return next(reader());
  }),
  opened('close() while cancel() goes on', 'end done done null', async ({ port, reader, next, how }) => {
    const one = reader();
    const read = next(one);
    const cancelled = how(one.cancel());
    const said = await read;
    one.releaseLock();
    return [said, await how(port.close()), await cancelled, port.readable];
  }),
  opened('a break: bytes, BreakError, a new stream', '[1,2] BreakError false [3]', async (lab) => {
    const { readable } = lab.port;
    const one = lab.reader();
    await lab.send(1, 2);
    const read = await lab.next(one);
    await lab.order('break');
    const error = await lab.next(one);
    await lab.send(3);
    return [read, error, lab.port.readable === readable, await lab.next(lab.reader())];
  }),
  opened('a break that a read waits for', 'BreakError BreakError pending done', async (lab) => {
    const one = lab.reader();
    const read = lab.how(one.read());
    await lab.order('break');
    const second = lab.reader();
    const said = [await read, await lab.how(one.closed), await lab.next(second)];
    for (const each of [one, second]) each.releaseLock();
    return [...said, await lab.how(lab.port.close())];
  }),
  probe('a wrong parity', 'ParityError DOMException', async ({ open, order, reader, log }) => {
    await open({ parity: 'even' });
    const read = reader().read();
    const failed = read.catch((error) => log.push(error.name, error.constructor.name));
    await order('parity');
    await failed;
  }),
  opened(
    'bytes, a break, and bytes in one burst',
    chromium('breakComesLast', '1 BreakError', '1 2 BreakError'),
    async ({ send, order, reader, next, log }) => {
      void send(1);
      void order('break');
      await send(2);
      const one = reader();
      while (!log.includes('BreakError')) log.push(...[await next(one)].flat());
    },
  ),
];
