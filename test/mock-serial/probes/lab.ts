import type { ChromiumWays } from '../../../src/mock-serial/index.js';

/** What a lab needs from the world behind the port. */
export interface Hands {
  /** The device sends bytes. */
  send(bytes: readonly number[]): Promise<unknown>;
  /** The next bytes that the device has received, at least so many. */
  receive(count: number): Promise<readonly number[]>;
  /** Something happens to the port. */
  order(
    what: 'unplug' | 'plug' | 'hold' | 'release' | 'hangup' | 'break' | 'parity' | 'choose' | 'dismiss',
  ): Promise<unknown>;
  /** Takes back what an earlier opening has left at the port. */
  free(): Promise<unknown>;
  /** Lets everything happen that will happen by itself. */
  rest(): Promise<unknown>;
}

/** A page with one port that it may use, plugged in and closed; and what lies behind the port. */
export interface Lab extends Omit<Hands, 'send' | 'free'> {
  readonly serial: Serial;
  readonly port: SerialPort;
  /** Opens the port at 9600 baud. */
  open(options?: Partial<SerialOptions>): Promise<SerialPort>;
  /** The device sends bytes; they arrive. */
  send(...bytes: number[]): Promise<void>;
  /** Plugs the device in again. @returns the port at which it is then */
  replug(): Promise<SerialPort>;
  reader(): ReadableStreamDefaultReader<Uint8Array>;
  writer(): WritableStreamDefaultWriter<unknown>;
  /** How it ends when a page opens the port and writes a chunk. */
  wrote(chunk: unknown): Promise<unknown>;
  /** What a reader gives next: bytes, `end`, an error by its name, or `pending`. */
  next(reader: { read(): Promise<ReadableStreamReadResult<Uint8Array>> }): Promise<unknown>;
  /** How something ends: its value, `done` for none, an error by its name, or `pending`. */
  how(what: unknown): Promise<unknown>;
  /** How it ends with each of these values: one answer, if it is always the same. */
  each<T>(values: readonly T[], what: (value: T) => unknown): Promise<unknown>;
  /** What a probe that gives nothing has noted. */
  readonly log: unknown[];
  /** What a probe gives, as text. */
  text(gives: unknown): string;
}

/** A small program for a page. It reaches nothing but the lab: a browser gets it as text. */
export interface Probe {
  readonly name: string;
  readonly run: (lab: Lab) => unknown;
  /** Whether the port is opened first, at 9600 baud. */
  readonly opens: boolean;
  /** What it gives by the standard and on the mock port. */
  readonly says: string;
  /** What it gives in Chromium. */
  readonly inChromium: string;
  /** The way of Chromium that the mock port takes, too, when it is asked to. */
  readonly way?: keyof ChromiumWays | undefined;
  /** Why the mock port never does the same. */
  readonly why?: string | undefined;
}

/** What a probe gives, or what it gives where the mock port and Chromium differ. */
type Gives = string | Pick<Probe, 'says' | 'inChromium' | 'way' | 'why'>;

export function probe(name: string, gives: Gives, run: Probe['run'], opens = false): Probe {
  return { name, run, opens, ...(typeof gives === 'string' ? { says: gives, inChromium: gives } : gives) };
}

/** A probe of an open port. */
export const opened = (name: string, gives: Gives, run: Probe['run']): Probe => probe(name, gives, run, true);

/** Chromium has a way of its own, which the mock port knows by name. */
export const chromium = (way: keyof ChromiumWays, says: string, inChromium: string): Gives => ({
  says,
  inChromium,
  way,
});

/** Chromium differs, and the mock port does not follow it. */
export const differs = (why: string, says: string, inChromium: string): Gives => ({ says, inChromium, why });

/** Makes a lab. It stands by itself, like a probe: it runs in the page. */
export function labOf(serial: Serial, port: SerialPort, hands: Hands): Lab {
  const { rest } = hands;
  const how = async (what: unknown): Promise<unknown> => {
    const given = (async () => (typeof what === 'function' ? what() : what))();
    const ended = given.then(
      (value) => (value === undefined ? 'done' : value),
      (error) => (/kills the tab/.test(error?.message) ? 'the tab dies' : (error?.name ?? error)),
    );
    return Promise.race([ended, rest().then(() => 'pending')]);
  };
  const open = async (options: Partial<SerialOptions> = {}): Promise<SerialPort> => {
    await hands.free();
    await port.open({ baudRate: 9600, ...options });
    return port;
  };
  const writer = (): WritableStreamDefaultWriter<unknown> => (port.writable as WritableStream<unknown>).getWriter();
  const log: unknown[] = [];
  return {
    ...hands,
    log,
    text(gives) {
      const texts = [gives ?? log].flat().map((each) => JSON.stringify(each ?? null));
      return texts.join(' ').replaceAll('"', '');
    },
    async each(values, what) {
      const all = await Promise.all(values.map((value) => how(() => what(value))));
      return all.every((it) => it === all[0]) ? all[0] : all;
    },
    serial,
    port,
    how,
    open,
    writer,
    async wrote(chunk) {
      await open();
      return how(writer().write(chunk));
    },
    async send(...bytes) {
      await hands.send(bytes);
      await rest();
    },
    async order(what) {
      await hands.order(what);
      await rest();
    },
    async replug() {
      await hands.order('plug');
      let ports: SerialPort[] = [];
      while (ports.length === 0) ports = await serial.getPorts();
      await rest();
      return ports[0] as SerialPort;
    },
    reader: () => (port.readable as ReadableStream<Uint8Array>).getReader(),
    next: (reader) => how(reader.read().then(({ done, value }) => (done ? 'end' : [...(value as Uint8Array)]))),
  };
}
