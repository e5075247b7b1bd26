import { chromium, differs, type Probe, probe } from './lab.js';

export const EVENTS: readonly Probe[] = [
  probe('what a handler can be', 'kept kept kept kept null null null null', ({ serial }) =>
    [() => {}, {}, [], null, undefined, 5, 'text', true].map((handler) => {
      serial.onconnect = handler as never;
      return serial.onconnect === handler ? 'kept' : serial.onconnect;
    }),
  ),
  probe('a handler is called on its object, with the event', 'true 1 connect', ({ port, log }) => {
    port.onconnect = function (this: unknown, ...all: Event[]) {
      log.push(this === port, all.length, all[0]?.type);
    };
    port.dispatchEvent(new Event('connect'));
  }),
  probe('a handler that cannot be called does nothing', 'true', ({ port, log }) => {
    port.onconnect = { handleEvent: () => log.push('called') } as never;
    log.push(port.dispatchEvent(new Event('connect', { cancelable: true })));
  }),
  probe('false from a handler cancels, nothing else does', 'false true true true true true', ({ port }) =>
    [false, true, 0, '', null, undefined].map((value) => {
      port.onconnect = (() => value) as never;
      return port.dispatchEvent(new Event('connect', { cancelable: true }));
    }),
  ),
  probe('a handler keeps its place; after null it comes last', 'second listener listener last', ({ serial, log }) => {
    serial.onconnect = {} as never;
    serial.addEventListener('connect', () => log.push('listener'));
    serial.onconnect = () => void log.push('second');
    serial.dispatchEvent(new Event('connect'));
    serial.onconnect = null;
    serial.onconnect = () => void log.push('last');
    serial.dispatchEvent(new Event('connect'));
  }),
  probe('an event goes down to the port and up again', 'S1 P2 P2 S3 0 true null []', ({ serial, port, log }) => {
    const note = ({ currentTarget, eventPhase, target }: Event): void => {
      if (target === port) log.push((currentTarget === port ? 'P' : 'S') + eventPhase);
    };
    for (const it of [serial, port]) for (const down of [false, true]) it.addEventListener('foo', note, down);
    const event = new Event('foo', { bubbles: true });
    port.dispatchEvent(event);
    log.push(event.eventPhase, event.target === port, event.currentTarget, event.composedPath());
  }),
  probe('its path', differs('Chromium forgets Serial, which the standard names', '2', '1'), ({ port, log }) => {
    port.addEventListener('foo', (event) => log.push(event.composedPath().length));
    port.dispatchEvent(new Event('foo', { bubbles: true }));
  }),
  probe('an event that does not bubble is caught on its way down', 'down port', ({ serial, port, log }) => {
    serial.addEventListener('foo', () => log.push('down'), true);
    serial.addEventListener('foo', () => log.push('up'));
    port.addEventListener('foo', () => log.push('port'));
    port.dispatchEvent(new Event('foo'));
  }),
  probe('what stops it, on the way down and at the port', 'd2 d2p2 d2 d2p2 d1 d2p1', ({ serial, port, log }) => {
    const stops: ((event: Event) => unknown)[] = [
      (event) => event.stopPropagation(),
      (event) => Object.assign(event, { cancelBubble: true }),
      (event) => event.stopImmediatePropagation(),
    ];
    for (const stop of stops)
      for (const place of ['d', 'p']) {
        const calls = { d: 0, p: 0 };
        const removal = new AbortController();
        const { signal } = removal;
        const hear = (at: 'd' | 'p') => (event: Event) => calls[at]++ === 0 && at === place && stop(event);
        for (const _ of [1, 2]) serial.addEventListener('foo', hear('d'), { capture: true, signal });
        for (const _ of [1, 2]) port.addEventListener('foo', hear('p'), { signal });
        serial.addEventListener('foo', () => log.push('up'), { signal });
        port.dispatchEvent(new Event('foo', { bubbles: true }));
        removal.abort();
        log.push(`d${calls.d}${calls.p ? `p${calls.p}` : ''}`);
      }
  }),
  probe('an event that is dispatched already; later it can be again', 'InvalidStateError true', (lab) => {
    const event = new Event('foo');
    const again = async (): Promise<boolean> => lab.port.dispatchEvent(event);
    let first: unknown;
    lab.port.addEventListener('foo', () => (first ??= lab.how(again)));
    lab.port.dispatchEvent(event);
    return Promise.all([first, again()]);
  }),
  probe('an event inside an event', 'foo bar bar foo', ({ serial, port, log }) => {
    const inside = (): void => void port.dispatchEvent(new Event('bar', { bubbles: true }));
    for (const it of [serial, port]) {
      it.addEventListener('foo', ({ type }) => log.push(type), true);
      it.addEventListener('bar', ({ type }) => log.push(type));
    }
    serial.addEventListener('foo', inside, true);
    port.dispatchEvent(new Event('foo'));
  }),
  probe('preventDefault() at Serial', 'false true', ({ serial, port }) => {
    serial.addEventListener('foo', (event) => event.preventDefault());
    return [true, false].map((cancelable) => port.dispatchEvent(new Event('foo', { bubbles: true, cancelable })));
  }),
  probe('a listener is added once for each phase, and removed', 'A A B A', ({ port, log }) => {
    const a = (): void => void log.push('A');
    const b = { handleEvent: () => void log.push('B') };
    for (const options of [undefined, false, { capture: false }, true, null])
      port.addEventListener('foo', a, options as never);
    port.addEventListener('foo', b);
    port.dispatchEvent(new Event('foo'));
    port.removeEventListener('foo', a, { capture: true });
    port.removeEventListener('foo', b);
    port.dispatchEvent(new Event('foo'));
  }),
  probe('once, and a signal that is aborted later or already', 'once signal', ({ port, log }) => {
    const controller = new AbortController();
    const { signal } = controller;
    port.addEventListener('foo', () => log.push('once'), { once: true });
    port.addEventListener('foo', () => log.push('signal'), { signal });
    port.dispatchEvent(new Event('foo'));
    controller.abort();
    port.addEventListener('foo', () => log.push('late'), { signal });
    port.dispatchEvent(new Event('foo'));
  }),
  probe('what a listener can be', 'done done done TypeError TypeError', ({ serial, each }) =>
    each([null, undefined, {}, 5, 'text'], (it) => serial.addEventListener('foo', it as never)),
  ),
  probe('what cannot be dispatched', 'TypeError', ({ port, each }) =>
    each([null, {}, 'foo'], (it) => port.dispatchEvent(it as never)),
  ),
  probe(
    'an unplug is told at the port, then at Serial',
    'P2false handler S3false',
    async ({ serial, port, order, log }) => {
      for (const it of [serial, port])
        it.addEventListener('disconnect', ({ currentTarget, eventPhase }) =>
          log.push((currentTarget === port ? 'P' : 'S') + eventPhase + port.connected),
        );
      port.ondisconnect = () => void log.push('handler');
      await order('unplug');
    },
  ),
  probe('its event', 'Event disconnect true false false null 0', async ({ serial, order }) => {
    const it = new Promise<Event>((resolve) => serial.addEventListener('disconnect', resolve));
    await order('unplug');
    const { type, bubbles, cancelable, composed, currentTarget, eventPhase } = await it;
    return [(await it).constructor.name, type, bubbles, cancelable, composed, currentTarget, eventPhase];
  }),
  probe('its trust', differs('only a browser gives it', 'false', 'true'), async ({ serial, order, log }) => {
    serial.addEventListener('disconnect', ({ isTrusted }) => log.push(isTrusted));
    await order('unplug');
  }),
  probe(
    'who hears it once',
    chromium('onceNeverFires', 'port serial', 'port'),
    async ({ serial, port, order, log }) => {
      serial.addEventListener('disconnect', () => log.push('serial'), { once: true });
      port.addEventListener('disconnect', () => log.push('port'), { once: true });
      await order('unplug');
    },
  ),
  probe('a listener for once at Serial hears the page', '1', ({ serial, log }) => {
    serial.addEventListener('disconnect', () => log.push(0), { once: true });
    for (const _ of [1, 2]) serial.dispatchEvent(new Event('disconnect'));
    return log.length;
  }),
  probe('who else hears it', 'down handler', async ({ serial, order, log }) => {
    serial.addEventListener('disconnect', () => log.push('down'), true);
    serial.ondisconnect = () => void log.push('handler');
    await order('unplug');
  }),
  probe('a device that comes is told', 'disconnect connect', async ({ serial, order, replug, log }) => {
    for (const type of ['connect', 'disconnect']) serial.addEventListener(type, () => log.push(type));
    await order('unplug');
    await replug();
  }),
];
