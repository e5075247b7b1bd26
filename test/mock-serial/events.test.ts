import { describe, expect, test, vi } from 'vitest';
import { MockSerial, type MockSerialPort } from '../../src/mock-serial/index.js';
import { settled } from './helper.js';

function plugged(): { serial: MockSerial; port: MockSerialPort } {
  const serial = new MockSerial();
  return { serial, port: serial.plug({}, { granted: true }) };
}

describe('connect and disconnect events', () => {
  test('are fired at the port, bubble to Serial, and never synchronously', async () => {
    const serial = new MockSerial();
    const seen: unknown[] = [];
    for (const type of ['connect', 'disconnect']) {
      serial.addEventListener(type, (event) =>
        seen.push([event.type, event.target, event.currentTarget, event.bubbles]),
      );
    }
    const port = serial.plug({}, { granted: true });
    port.addEventListener('connect', (event) => seen.push([event.type, event.target, event.currentTarget]));
    expect(seen).toEqual([]);
    await settled();
    expect(seen).toEqual([
      ['connect', port, port],
      ['connect', port, serial, true],
    ]);
    seen.length = 0;
    serial.unplug(port);
    expect(seen).toEqual([]);
    expect(port.connected).toBe(false);
    await settled();
    expect(seen).toEqual([['disconnect', port, serial, true]]);
    serial.replug(port, { samePort: true });
    expect(port.connected).toBe(true);
    await settled();
    expect(seen.at(-1)).toEqual(['connect', port, serial, true]);
  });

  test('are an Event, with target and phase of the DOM standard', async () => {
    const { serial, port } = plugged();
    const phases: number[] = [];
    serial.addEventListener('disconnect', (it) => phases.push(it.eventPhase), true);
    let event: Event | undefined;
    port.addEventListener('disconnect', (it) => phases.push(it.eventPhase));
    serial.addEventListener('disconnect', (it) => {
      event = it;
      phases.push(it.eventPhase);
      expect(it.composedPath()).toEqual([port, serial]);
    });
    serial.unplug(port);
    await settled();
    expect(event).toBeInstanceOf(Event);
    expect(phases).toEqual([Event.CAPTURING_PHASE, Event.AT_TARGET, Event.BUBBLING_PHASE]);
    expect(event?.target).toBe(port);
    expect(event?.currentTarget).toBeNull();
    expect(event?.eventPhase).toBe(Event.NONE);
    expect(event?.composedPath()).toEqual([]);
  });

  test('are fired only for a port that the site may use', async () => {
    const serial = new MockSerial({ userActivation: true });
    const seen: string[] = [];
    serial.onconnect = (event) => seen.push(event.type);
    serial.ondisconnect = (event) => seen.push(event.type);
    const port = serial.plug();
    serial.choose(port);
    await settled();
    expect(seen).toEqual([]);
    await serial.requestPort();
    serial.unplug(port);
    await settled();
    expect(seen).toEqual(['disconnect']);
  });

  test('are not fired again for what is unplugged or plugged in already', async () => {
    const { serial, port } = plugged();
    const seen: string[] = [];
    await settled();
    serial.onconnect = (event) => seen.push(event.type);
    serial.ondisconnect = (event) => seen.push(event.type);
    serial.replug(port, { samePort: true });
    serial.unplug(port);
    serial.unplug(port);
    await settled();
    expect(seen).toEqual(['disconnect']);
  });
});

describe('onconnect and ondisconnect attributes', () => {
  test('of Serial and SerialPort are called with the event, on their object', async () => {
    const { serial, port } = plugged();
    const seen: unknown[] = [];
    for (const target of [serial, port]) {
      target.onconnect = function (this: unknown, event: Event) {
        seen.push([event.type, this]);
      };
      target.ondisconnect = function (this: unknown, event: Event) {
        seen.push([event.type, this]);
      };
    }
    await settled();
    serial.unplug(port);
    await settled();
    expect(seen).toEqual([
      ['connect', port],
      ['connect', serial],
      ['disconnect', port],
      ['disconnect', serial],
    ]);
  });

  test('return what was set, and can be replaced and removed', async () => {
    const { serial, port } = plugged();
    const first = vi.fn();
    const second = vi.fn();
    expect(serial.ondisconnect).toBeNull();
    serial.onconnect = first;
    expect(serial.onconnect).toBe(first);
    serial.onconnect = null;
    serial.ondisconnect = first;
    serial.ondisconnect = second;
    expect(serial.ondisconnect).toBe(second);
    serial.addEventListener('disconnect', second);
    serial.unplug(port);
    await settled();
    expect(first).not.toHaveBeenCalled();
    expect(second).toHaveBeenCalledTimes(2);
    serial.ondisconnect = null;
    expect(serial.ondisconnect).toBeNull();
    serial.replug(port, { samePort: true });
    serial.unplug(port);
    await settled();
    expect(second).toHaveBeenCalledTimes(3);
  });
});

describe('the event path from SerialPort to Serial', () => {
  /** What hears an event of type `foo`, in which order. */
  function listening(): { serial: MockSerial; port: MockSerialPort; heard: string[]; names: Map<unknown, string> } {
    const { serial, port } = plugged();
    const names = new Map<unknown, string>([
      [serial, 'serial'],
      [port, 'port'],
    ]);
    const heard: string[] = [];
    for (const target of [serial, port]) {
      target.addEventListener('foo', (event) => heard.push(`bubbling ${names.get(event.currentTarget)}`));
      target.addEventListener('foo', (event) => heard.push(`capturing ${names.get(event.currentTarget)}`), true);
    }
    return { serial, port, heard, names };
  }
  const event = (): Event => new Event('foo', { bubbles: true, cancelable: true });

  test('goes down and up again', () => {
    const { port, heard } = listening();
    expect(port.dispatchEvent(event())).toBe(true);
    expect(heard).toEqual(['capturing serial', 'capturing port', 'bubbling port', 'bubbling serial']);
  });

  test('does not go up for an event that does not bubble', () => {
    const { port, heard } = listening();
    port.dispatchEvent(new Event('foo'));
    expect(heard).toEqual(['capturing serial', 'capturing port', 'bubbling port']);
  });

  test.each([
    ['stopPropagation()', (it: Event) => it.stopPropagation()],
    [
      'cancelBubble',
      (it: Event) => {
        it.cancelBubble = true;
      },
    ],
  ])('%s stops it on the way down and on the way up', (_, stop) => {
    const down = listening();
    down.serial.addEventListener('foo', stop, { capture: true });
    down.serial.addEventListener('foo', () => down.heard.push('its neighbour'), { capture: true });
    down.port.dispatchEvent(event());
    expect(down.heard).toEqual(['capturing serial', 'its neighbour']);
    const up = listening();
    up.port.addEventListener('foo', stop);
    up.port.dispatchEvent(event());
    expect(up.heard).toEqual(['capturing serial', 'capturing port', 'bubbling port']);
  });

  test('stopImmediatePropagation() keeps it from the other listeners of the same object', () => {
    const { port, heard } = listening();
    port.addEventListener('bar', (it) => it.stopImmediatePropagation());
    port.addEventListener('bar', () => heard.push('bar'));
    port.dispatchEvent(new Event('bar', { bubbles: true }));
    expect(heard).toEqual([]);
  });

  test('an event dispatched by a listener is heard before the first goes on', () => {
    const { serial, port } = plugged();
    const heard: string[] = [];
    serial.addEventListener(
      'foo',
      () => {
        heard.push('foo serial');
        port.dispatchEvent(new Event('bar', { bubbles: true }));
      },
      { capture: true },
    );
    port.addEventListener('foo', () => heard.push('foo port'));
    for (const target of [serial, port]) target.addEventListener('bar', () => heard.push('bar'));
    port.dispatchEvent(event());
    expect(heard).toEqual(['foo serial', 'bar', 'bar', 'foo port']);
  });

  test('the same event cannot be dispatched twice at a time, but can be again', () => {
    const { port, heard } = listening();
    const once = event();
    port.addEventListener('foo', () => expect(() => port.dispatchEvent(once)).toThrow(DOMException), { once: true });
    port.dispatchEvent(once);
    port.dispatchEvent(once);
    expect(heard).toHaveLength(8);
  });

  test('says whether a listener prevented the default', () => {
    const { port, serial } = listening();
    serial.addEventListener('foo', (it) => it.preventDefault());
    expect(port.dispatchEvent(event())).toBe(false);
  });
});

describe('EventTarget of the DOM standard', () => {
  test('a listener is added once, heard in order, and removed', () => {
    const { port } = plugged();
    const heard: string[] = [];
    const first = (): void => void heard.push('first');
    const second = { handleEvent: () => void heard.push('second') };
    port.addEventListener('foo', first);
    port.addEventListener('foo', first, { capture: false });
    port.addEventListener('foo', second);
    port.addEventListener('foo', null);
    port.dispatchEvent(new Event('foo'));
    expect(heard).toEqual(['first', 'second']);
    port.removeEventListener('foo', first, true);
    port.removeEventListener('foo', second);
    port.dispatchEvent(new Event('foo'));
    expect(heard).toEqual(['first', 'second', 'first']);
    port.addEventListener('foo', second);
    port.dispatchEvent(new Event('foo'));
    expect(heard.slice(3)).toEqual(['first', 'second']);
  });

  test('once, and a signal', () => {
    const { port } = plugged();
    const once = vi.fn();
    const limited = vi.fn();
    const controller = new AbortController();
    port.addEventListener('foo', once, { once: true });
    port.addEventListener('foo', limited, { signal: controller.signal });
    port.dispatchEvent(new Event('foo'));
    controller.abort();
    port.addEventListener('foo', limited, { signal: controller.signal });
    port.dispatchEvent(new Event('foo'));
    expect(once).toHaveBeenCalledTimes(1);
    expect(limited).toHaveBeenCalledTimes(1);
  });
});
