import { chromium, type Probe, probe } from './lab.js';

export const UNTOUCHED: readonly Probe[] = [
  probe('without a click', 'SecurityError', ({ serial, how }) => how(serial.requestPort())),
  probe('a wrong type comes first', 'TypeError', ({ serial, how }) => how(serial.requestPort({ filters: 5 as never }))),
  probe('a wrong filter does not', 'SecurityError', ({ serial, how }) => how(serial.requestPort({ filters: [{}] }))),
  probe(
    'its members are read in the order of their names, and each is converted at once',
    'allowedBluetoothServiceClassIds filters bluetoothServiceClassId usbProductId 1 usbVendorId 2',
    async ({ serial, how, log }) => {
      const number = (value: number) => ({ valueOf: () => log.push(value) });
      const watched = (of: object): object =>
        new Proxy(of, {
          get: (target, name) => {
            log.push(name);
            return Reflect.get(target, name);
          },
        });
      const filters = [watched({ usbVendorId: number(2), usbProductId: number(1) })];
      await how(serial.requestPort(watched({ filters })));
    },
  ),
  probe('an error of the page’s own comes out', 'RangeError', ({ serial, how }) =>
    how(serial.requestPort({ filters: [{ usbVendorId: { valueOf: () => new Array(-1) } as never }] })),
  ),
];

export const REQUEST: readonly Probe[] = [
  probe('what options cannot be', 'TypeError', ({ serial, each }) =>
    each([5, 'text', true], (options) => serial.requestPort(options as never)),
  ),
  probe('what filters cannot be', 'TypeError', ({ serial, each }) =>
    each([5, 'ab', {}, null, [5], ['ab']], (filters) => serial.requestPort({ filters: filters as never })),
  ),
  probe('what allowed service classes cannot be', 'TypeError', ({ serial, each }) =>
    each([5, 'ab', {}, null], (ids) => serial.requestPort({ allowedBluetoothServiceClassIds: ids as never })),
  ),
  probe('a filter that is empty, lacks its vendor, or has too much', 'TypeError', ({ serial, each }) => {
    const bluetoothServiceClassId = 0x1101;
    const mixed = [{ usbVendorId: 1 }, { usbProductId: 1 }].map((usb) => ({ ...usb, bluetoothServiceClassId }));
    return each([{}, null, undefined, { usbProductId: 1 }, ...mixed], (filter) =>
      serial.requestPort({ filters: [{ usbVendorId: 1 }, filter as never] }),
    );
  }),
  probe('service classes that are none', 'TypeError', ({ serial, each }) =>
    each(['serial', '', '1101', '01234567-89AB-CDEF-0123-456789ABCDEF', null, {}], async (id) => {
      const refused = serial.requestPort({ allowedBluetoothServiceClassIds: [id as never] });
      await refused.catch(() => serial.requestPort({ filters: [{ bluetoothServiceClassId: id as never }] }));
    }),
  ),
  probe('a USB number that is none', 'TypeError', ({ serial, each }) =>
    each([1n, Symbol.iterator], (it) => serial.requestPort({ filters: [{ usbVendorId: it as never }] })),
  ),
  probe(
    'a chosen port: the same object; numbers of a filter are converted',
    'true',
    async ({ serial, port, order }) => {
      const filters = [{ usbVendorId: '0x10403' as never, usbProductId: 0x6001 + 0.9 }];
      const asked = serial.requestPort({ filters });
      await order('choose');
      return (await asked) === port;
    },
  ),
  probe('no port is chosen', 'NotFoundError', async ({ serial, order, how }) => {
    const asked = serial.requestPort().catch(({ name }) => name);
    await order('dismiss');
    return how(asked);
  }),
  probe('a port that was forgotten and is chosen again', 'true done 1', async ({ serial, port, order, how }) => {
    await port.forget();
    const asked = serial.requestPort();
    await order('choose');
    return [(await asked) === port, await how(port.open({ baudRate: 9600 })), (await serial.getPorts()).length];
  }),
  probe(
    'one that was open when it was forgotten: is its stream back?',
    chromium('forgottenStreamReturns', 'false pending', 'true [1,2]'),
    async ({ serial, port, open, send, order, reader, next }) => {
      await open();
      const { readable } = port;
      await send(1, 2);
      await port.forget();
      const asked = serial.requestPort();
      await order('choose');
      await asked;
      await open();
      return [port.readable === readable, await next(reader())];
    },
  ),
];
