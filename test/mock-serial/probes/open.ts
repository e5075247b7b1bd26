import { chromium, differs, opened, type Probe, probe } from './lab.js';

const NO_LINES = 'the pty of the rig has no control lines';

export const OPEN: readonly Probe[] = [
  probe('no options', 'TypeError', ({ port, each }) =>
    each([[], [undefined], [null], [5], ['text'], [{}]], (all) => Reflect.apply(port.open, port, all)),
  ),
  probe('what baudRate cannot be', 'TypeError', ({ port, each }) =>
    each([-1, 0, 2 ** 32, Number.NaN, Number.POSITIVE_INFINITY, 'fast', null, 1n, Symbol.iterator, -0.5], (baudRate) =>
      port.open({ baudRate: baudRate as never }),
    ),
  ),
  probe('what dataBits and stopBits cannot be', 'TypeError', ({ port, each }) =>
    each([-1, 0, 3, 6, 9, 256 + 1, 256 + 8, null, 'text', 1n], async (bits) => {
      const refused = port.open({ baudRate: 9600, dataBits: bits as never });
      await refused.catch(() => port.open({ baudRate: 9600, stopBits: bits as never }));
    }),
  ),
  probe('what parity and flowControl cannot be', 'TypeError', ({ port, each }) =>
    each([0, null, '', 'mark', 'NONE', 'software'], async (word) => {
      const refused = port.open({ baudRate: 9600, parity: word as never });
      await refused.catch(() => port.open({ baudRate: 9600, flowControl: word as never }));
    }),
  ),
  probe('what bufferSize cannot be', 'TypeError', ({ port, each }) =>
    each([-1, 0, 2 ** 24 + 1, 2 ** 32 + 1, null, 'text'], (bufferSize) =>
      port.open({ baudRate: 9600, bufferSize: bufferSize as never }),
    ),
  ),
  probe('what the options can be', 'done', async ({ port, open, how }) => {
    const none = { toString: () => 'none' };
    const rates = ['9600', '0x2580', 115200.7, { valueOf: () => 9600 }, 250000].map((baudRate) => ({ baudRate }));
    const sizes = [{ dataBits: 7 }, { dataBits: '8' }, { stopBits: 2.9 }, { bufferSize: 1 }, { bufferSize: 2 ** 24 }];
    const words = [{ stopBits: undefined }, { parity: 'even' }, { parity: none }, { flowControl: none }];
    for (const options of [...rates, ...sizes, ...words]) {
      await open(options as { baudRate: number });
      await port.close();
    }
    return how(undefined);
  }),
  probe(
    'the options are read in the order of their names',
    'baudRate bufferSize dataBits flowControl parity stopBits',
    async ({ port, log }) => {
      const get = (_: object, name: string | symbol) => (log.push(name) === 1 ? 9600 : undefined);
      const options = new Proxy<SerialOptions>({ baudRate: 9600 }, { get });
      await port.open(options);
    },
  ),
  probe('a refusal leaves the port closed', 'null InvalidStateError done', async ({ port, how }) => {
    await how(port.open({ baudRate: 0 }));
    return [port.readable, await how(port.close()), await how(port.open({ baudRate: 9600 }))];
  }),
  probe('twice, while it opens, and close() then', 'InvalidStateError done InvalidStateError', async (lab) => {
    const options = { baudRate: 9600 };
    const first = lab.port.open(options);
    const during = await lab.each([() => lab.port.open(options), () => lab.port.close()], (it) => it());
    return [during, await lab.how(first), await lab.how(lab.port.open(options))];
  }),
  opened('that it is open comes before a wrong number', 'InvalidStateError', ({ port, each }) =>
    each([{ baudRate: 0 }, { baudRate: 9600, dataBits: 6 as never }], (options) => port.open(options)),
  ),
  opened('a wrong word comes before that', 'TypeError', ({ port, each }) =>
    each([{ baudRate: 9600, parity: 'mark' as never }, {} as never], (options) => port.open(options)),
  ),
  probe('another program has it', 'NetworkError true null done', async ({ port, order, how }) => {
    await order('hold');
    const refused = await how(port.open({ baudRate: 9600 }));
    await order('release');
    return [refused, port.connected, port.readable, await how(port.open({ baudRate: 9600 }))];
  }),
  probe('streams while it opens', 'null null', async ({ port }) => {
    const opening = port.open({ baudRate: 9600 });
    const during = [port.readable, port.writable];
    await opening;
    return during;
  }),
  opened('streams', '[object ReadableStream] [object WritableStream] true', ({ port }) => {
    const { readable, writable } = port;
    return [`${readable}`, `${writable}`, port.readable === readable && port.writable === writable];
  }),
  probe('close() of a closed port', 'InvalidStateError', ({ port, how }) => how(port.close())),
  opened('close() gives nothing', 'undefined', async ({ port }) => typeof (await port.close())),
  opened('close() twice, and open() during it', 'InvalidStateError done InvalidStateError', async (lab) => {
    const closing = lab.port.close();
    const during = await lab.each([() => lab.port.open({ baudRate: 9600 }), () => lab.port.close()], (it) => it());
    return [during, await lab.how(closing), await lab.how(lab.port.close())];
  }),
  opened('close() while readable is locked', 'TypeError [1] done null', async ({ port, reader, send, next, how }) => {
    const locked = reader();
    const refused = await how(port.close());
    await send(1);
    const read = await next(locked);
    locked.releaseLock();
    return [refused, read, await how(port.close()), port.readable];
  }),
  opened('close() while writable is locked', 'TypeError [1] done null', async ({ port, writer, receive, how }) => {
    const locked = writer();
    const refused = await how(port.close());
    await locked.write(Uint8Array.of(1));
    locked.releaseLock();
    return [refused, await receive(1), await how(port.close()), port.writable];
  }),
  opened(
    'readable after a close() that writable has stopped',
    chromium('failedCloseKills', '[object ReadableStream]', 'the tab dies'),
    async ({ port, writer, how, rest }) => {
      void port.readable;
      writer();
      await how(port.close());
      const said = await how(() => String(port.readable));
      await rest();
      return said;
    },
  ),
  opened('readable during close()', chromium('closingHidesReadable', 'true null', 'false null'), async ({ port }) => {
    const { readable } = port;
    const closing = port.close();
    const during = port.readable === readable;
    await closing;
    return [during, port.readable];
  }),
  opened('writable during close()', 'true null', async ({ port }) => {
    const { writable } = port;
    const closing = port.close();
    const during = port.writable === writable;
    await closing;
    return [during, port.writable];
  }),
  opened('streams that nobody had fetched, during close()', 'null null', async ({ port }) => {
    const closing = port.close();
    const during = [port.readable, port.writable];
    await closing;
    return during;
  }),
  opened('the old streams after close()', 'end InvalidStateError', async ({ port, send, how, next }) => {
    const { readable, writable } = port;
    await send(1, 2, 3);
    await port.close();
    return [await next(readable?.getReader() as never), await how(writable?.getWriter().write(Uint8Array.of(1)))];
  }),
  opened('what was not read, and what came meanwhile, is gone', '4', async ({ port, open, send, reader, next }) => {
    await send(1, 2);
    await port.close();
    await send(3);
    await open();
    await send(4);
    return next(reader());
  }),
  opened('a read whose lock is gone does not stop close()', 'TypeError done', async ({ port, reader, how }) => {
    const one = reader();
    const read = how(one.read());
    one.releaseLock();
    return [await read, await how(port.close())];
  }),
  probe('signals while it is closed', 'InvalidStateError', ({ port, each }) =>
    each([() => port.getSignals(), () => port.setSignals({ break: true }), () => port.setSignals({})], (it) => it()),
  ),
  opened('setSignals() with nothing to set', 'TypeError', ({ port, each }) =>
    each([undefined, null, {}, { break: undefined }, { mine: true }, 5, 'text'], (it) => port.setSignals(it as never)),
  ),
  opened('the signals are read in order', 'break dataTerminalReady requestToSend', async ({ port, how, log }) => {
    await how(port.setSignals(new Proxy({}, { get: (_, name) => void log.push(name) })));
  }),
  opened(
    'getSignals() in the order of their names',
    differs(NO_LINES, 'clearToSend dataCarrierDetect dataSetReady ringIndicator', 'NetworkError'),
    ({ port, how }) => how(async () => Object.keys(await port.getSignals())),
  ),
  opened('setSignals() with any value', differs(NO_LINES, 'done', 'NetworkError'), ({ port, each }) =>
    each([{ dataTerminalReady: 0 }, { requestToSend: 'yes', break: null }], (it) => port.setSignals(it as never)),
  ),
];
