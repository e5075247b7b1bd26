import { chromium, opened, type Probe, probe } from './lab.js';

export const LOSS: readonly Probe[] = [
  opened('a read that waits; then readable is null', 'NetworkError DOMException null', async (lab) => {
    const one = lab.reader();
    const read = lab.how(one.read());
    const error = one.closed.catch((it) => it.constructor.name);
    await lab.order('unplug');
    return [await read, await error, lab.port.readable];
  }),
  opened('streams that nobody had fetched', '[object WritableStream] NetworkError null', async (lab) => {
    await lab.order('unplug');
    return [String(lab.port.writable), await lab.next(lab.reader()), lab.port.readable];
  }),
  opened('what had come is read first', '[1,2] NetworkError null', async ({ port, reader, send, order, next }) => {
    const one = reader();
    await send(1, 2);
    await order('unplug');
    return [await next(one), await next(one), port.readable];
  }),
  opened('cancel() with bytes: there is no stream after it', 'done null', async ({ port, send, order, how }) => {
    const { readable } = port;
    await send(1, 2);
    await order('unplug');
    return [await how(readable?.cancel()), port.readable];
  }),
  opened('cancel() without', 'done null', async ({ port, order, how }) => {
    const { readable } = port;
    await order('unplug');
    return [await how(readable?.cancel()), port.readable];
  }),
  opened('the first write', chromium('firstLostWriteResolves', 'NetworkError', 'done'), async (lab) => {
    const one = lab.writer();
    await lab.order('unplug');
    return lab.how(one.write(Uint8Array.of(1)));
  }),
  opened('the next; then writable is null', 'NetworkError null', async ({ port, writer, order, how }) => {
    const one = writer();
    await order('unplug');
    await how(one.write(Uint8Array.of(1)));
    // Chromium notices the loss a moment later.
    await how(new Promise(() => {}));
    return [await how(one.write(Uint8Array.of(1))), port.writable];
  }),
  opened('the stream after the first', 'NetworkError null', async ({ port, writer, order, how }) => {
    const one = writer();
    await order('unplug');
    await how(one.write(Uint8Array.of(1)));
    return [await how(one.closed.catch(({ name }) => name)), port.writable];
  }),
  opened('writable that nobody uses lives on', 'NetworkError true', async ({ port, reader, order, how }) => {
    const { writable } = port;
    const read = how(reader().read());
    await order('unplug');
    return [await read, port.writable === writable];
  }),
  opened(
    'close() of a writer with nothing to send: a new stream',
    'done false',
    async ({ port, writer, order, how }) => {
      const { writable } = port;
      const one = writer();
      await order('unplug');
      return [await how(one.close()), port.writable === writable];
    },
  ),
  opened(
    'close() of a writer, then a write',
    chromium('firstLostWriteResolves', 'NetworkError', 'done'),
    async (lab) => {
      const one = lab.writer();
      await lab.order('unplug');
      await lab.how(one.close());
      return lab.how(lab.writer().write(Uint8Array.of(1)));
    },
  ),
  opened('abort()', 'done', async ({ writer, order, how }) => {
    const one = writer();
    await order('unplug');
    return how(one.abort('mine'));
  }),
  opened('connected, getPorts() and getInfo()', 'false [] 1027', async ({ serial, port, order }) => {
    await order('unplug');
    return [port.connected, await serial.getPorts(), port.getInfo().usbVendorId];
  }),
  opened('signals', 'NetworkError', async ({ port, order, each }) => {
    await order('unplug');
    return each([() => port.getSignals(), () => port.setSignals({ break: true })], (it) => it());
  }),
  opened(
    'close() while locked, and after',
    'TypeError done null null',
    async ({ port, reader, writer, order, how }) => {
      const locked = [reader(), writer()];
      await order('unplug');
      const refused = await how(port.close());
      for (const each of locked) each.releaseLock();
      return [refused, await how(port.close()), port.readable, port.writable];
    },
  ),
  opened('close() with streams that nobody had fetched', 'done', async ({ port, order, how }) => {
    await order('unplug');
    return how(port.close());
  }),
  probe('open()', 'NetworkError null', async ({ port, order, how }) => {
    await order('unplug');
    return [await how(port.open({ baudRate: 9600 })), port.readable];
  }),
  probe('it comes back as another port', 'false false true 1027 1', async ({ serial, port, order, replug }) => {
    await order('unplug');
    const again = await replug();
    const { length } = await serial.getPorts();
    return [again === port, port.connected, again.connected, again.getInfo().usbVendorId, length];
  }),
  opened('the old port stays lost; the new one works', '[6] done NetworkError', async (lab) => {
    await lab.order('unplug');
    const again = await lab.replug();
    await again.open({ baudRate: 9600 });
    await again.writable?.getWriter().write(Uint8Array.of(6));
    return [await lab.receive(1), await lab.how(lab.port.close()), await lab.how(lab.port.open({ baudRate: 9600 }))];
  }),
  opened('the new port reads', '5', async ({ order, replug, send, next }) => {
    await order('unplug');
    const again = await replug();
    await again.open({ baudRate: 9600 });
    await send(5);
    return next(again.readable?.getReader() as never);
  }),
  opened(
    'an adapter that fails and is not unplugged',
    'NetworkError null true',
    async ({ port, reader, order, how }) => {
      const read = how(reader().read());
      await order('hangup');
      return [await read, port.readable, port.connected];
    },
  ),
  opened('forget(): the streams end', 'done NetworkError null null NetworkError', async (lab) => {
    const read = lab.how(lab.reader().read());
    const one = lab.writer();
    const done = await lab.how(lab.port.forget());
    return [done, await read, lab.port.readable, lab.port.writable, await lab.how(one.write(Uint8Array.of(1)))];
  }),
  opened('forget(): streams that nobody uses', 'NetworkError NetworkError null', async (lab) => {
    const [one, two] = [lab.reader(), lab.writer()];
    await lab.port.forget();
    return [await lab.next(one), await lab.how(two.closed), lab.port.readable];
  }),
  opened('forget(): what had come is read first', '[1,2] NetworkError null', async ({ port, reader, send, next }) => {
    const one = reader();
    await send(1, 2);
    await port.forget();
    return [await next(one), await next(one), port.readable];
  }),
  opened('forget(): the state is closed', 'InvalidStateError', async ({ port, each, rest }) => {
    await Promise.all([port.forget(), rest()]); // Chromium gets there a moment after forget().
    return each([() => port.close(), () => port.getSignals(), () => port.setSignals({ break: true })], (it) => it());
  }),
  probe('forget() twice; then open() and getPorts()', 'done done NetworkError []', async ({ serial, port, how }) => [
    await how(port.forget()),
    await how(port.forget()),
    await how(port.open({ baudRate: 9600 })),
    await serial.getPorts(),
  ]),
  probe('forget(): no event, and connected does not change', 'true', async ({ serial, port, order, log }) => {
    serial.addEventListener('disconnect', () => log.push('disconnect'));
    await port.forget();
    await order('unplug');
    log.push(port.connected);
  }),
];
