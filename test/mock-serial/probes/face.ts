import { differs, type Probe, probe } from './lab.js';

export const FACE: readonly Probe[] = [
  probe('both have their names', '[object Serial] [object SerialPort]', ({ serial, port }) => [`${serial}`, `${port}`]),
  probe('their constructors', differs('a mock says so', 'MockSerial MockSerialPort', 'Serial SerialPort'), (lab) =>
    [lab.serial, lab.port].map((it) => it.constructor.name),
  ),
  probe('their constructors cannot be called', differs('a test calls them', '{} {}', 'TypeError'), (lab) =>
    lab.each([lab.serial, lab.port], (it) => Reflect.construct(it.constructor as () => void, [])),
  ),
  probe('what is seen of Serial', 'getPorts onconnect ondisconnect requestPort', ({ serial }) =>
    Object.keys(Object.getPrototypeOf(serial)).sort(),
  ),
  probe(
    'what is seen of SerialPort',
    'close connected forget getInfo getSignals onconnect ondisconnect open readable setSignals writable',
    ({ port }) => Object.keys(Object.getPrototypeOf(port)).sort(),
  ),
  probe('neither has members of its own', '[] []', ({ serial, port }) => [Object.keys(serial), Object.keys(port)]),
  probe('attributes have a getter, handlers a setter, too', '3 2 2', ({ port }) => {
    const all = Object.values(Object.getOwnPropertyDescriptors(Object.getPrototypeOf(port)));
    const seen = all.filter(({ enumerable, configurable, get }) => enumerable && configurable && get);
    const withSetter = seen.filter(({ set }) => set);
    return [
      seen.length - withSetter.length,
      withSetter.length,
      withSetter.filter(({ set }) => set?.length === 1).length,
    ];
  }),
  probe(
    'methods have names and lengths',
    'open1 close0 forget0 getInfo0 getSignals0 setSignals0 getPorts0 requestPort0',
    ({ port: it, serial }) =>
      [it.open, it.close, it.forget, it.getInfo, it.getSignals, it.setSignals, serial.getPorts, serial.requestPort].map(
        ({ name, length }) => name + length,
      ),
  ),
  probe('attributes cannot be set', 'TypeError', ({ port, each }) =>
    each(['connected', 'readable', 'writable'], (name) => Object.assign(port, { [name]: null })),
  ),
  probe('methods of another object reject', 'TypeError', ({ serial, port, each }) =>
    each(
      [serial.getPorts, serial.requestPort, port.open, port.close, port.forget, port.getSignals, port.setSignals],
      (method) => (method as () => Promise<unknown>).call({}).catch((error) => Promise.reject(error)),
    ),
  ),
  probe('getInfo() and attributes of another object throw', 'TypeError', ({ port, each }) =>
    each(['getInfo', 'connected', 'readable', 'writable', 'onconnect'], (name) => {
      const { get, value } = Object.getOwnPropertyDescriptor(Object.getPrototypeOf(port), name) ?? {};
      (get ?? value).call({});
    }),
  ),
  probe('all methods but getInfo give promises', 'true', ({ serial, port, each }) =>
    each(
      [serial.getPorts, serial.requestPort, port.open, port.close, port.getSignals, port.setSignals, port.forget],
      (method) => {
        const made = (method as () => Promise<unknown>).call(method.name.endsWith('s') ? serial : port);
        made.catch(() => {});
        return made instanceof Promise;
      },
    ),
  ),
  probe('a copy of a port', differs('only a browser can refuse it', '{}', 'DataCloneError'), ({ port, how }) =>
    how(() => structuredClone(port)),
  ),
  probe('a port as JSON', '{}', ({ port }) => JSON.stringify(port)),
  probe('getPorts() gives a new list of the same ports', 'false 1 true', async ({ serial }) => {
    const [one, two] = [await serial.getPorts(), await serial.getPorts()];
    return [one === two, one.length, one[0] === two[0]];
  }),
  probe('getInfo() gives the members in the order of their names', '{usbProductId:24577,usbVendorId:1027}', (lab) =>
    lab.port.getInfo(),
  ),
  probe('a new port', 'true null null null null', ({ port }) => [
    port.connected,
    port.readable,
    port.writable,
    port.onconnect,
    port.ondisconnect,
  ]),
];
