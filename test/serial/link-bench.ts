import { expect, onTestFinished } from 'vitest';
import type { LineEntry } from '../../src/client/index.js';
import { type CommandName, commandOf } from '../../src/protocol/index.js';
import {
  type LinkState,
  type SerialLike,
  type SerialPortLike,
  type SerialSettings,
  TimerLink,
  type TimerLinkOptions,
} from '../../src/serial/index.js';
import { serialBench, type TimerOptions } from './bench.js';

/** Sent only by a person's own act. */
const DANGEROUS: readonly CommandName[] = ['UNLOCK', 'JUMP2', 'MOVETOFUNC'];

export interface LinkBenchOptions extends TimerOptions {
  readonly link?: Omit<TimerLinkOptions, 'clock' | 'onLine' | 'onState'>;
}

/** A link to an adapter and its timer, on a clock that the test turns, with everything that it reported and sent. */
export function linkBench({ link: linkOptions, ...options }: LinkBenchOptions = {}) {
  const bench = serialBench({ info: { usbVendorId: 0x0403, usbProductId: 0x6001 }, ...options });
  const { clock, serial, port } = bench;
  serial.choose(port);
  const states: LinkState[] = [];
  const line: LineEntry[] = [];
  const link = new TimerLink({
    serial,
    clock,
    onLine: (entry) => line.push(entry),
    onState: (state) => states.push(state),
    ...linkOptions,
  });
  onTestFinished(() => {
    for (const name of sent(line)) expect(DANGEROUS).not.toContain(name);
  });

  /** Connects, and turns the clock until the link has settled. */
  const connect = (at: SerialPortLike = port, settings?: SerialSettings): Promise<void> =>
    clock.run(link.connect(at, settings));

  return { ...bench, link, states, line, connect };
}

export type LinkBench = ReturnType<typeof linkBench>;

/** A link that is on; its reports are counted from here. */
export async function on(options: LinkBenchOptions = {}): Promise<LinkBench> {
  const bench = linkBench(options);
  await bench.connect();
  expect(bench.link.state.status).toBe('on');
  bench.states.length = 0;
  bench.line.length = 0;
  return bench;
}

/** The names of the requests that went out. */
export function sent(line: readonly LineEntry[]): (CommandName | undefined)[] {
  const out = line.filter(({ direction }) => direction === 'out');
  return out.map(({ frame }) => frame && commandOf(frame.code)?.name) as (CommandName | undefined)[];
}

/** The way of a link, a word for each state. Several states of one status in a row give one word. */
export function way(states: readonly LinkState[]): string {
  const words = states.map((state) =>
    state.status === 'off' && state.error ? `off (${state.error.code})` : state.status,
  );
  return words.filter((word, i) => word !== words[i - 1]).join(' > ');
}

/** The exact port at which a link is, or that it has lost. Two ports of one kind are equal by value. */
export function portOf({ state }: TimerLink): SerialPortLike | null {
  return 'port' in state ? state.port : null;
}

/** The connection of a link that is on. */
export function connectionOf({ state }: TimerLink) {
  if (state.status !== 'on') throw new Error(`the link must be on, but it is ${state.status}`);
  return state.connection;
}

/** A browser whose chooser stays open until the pilot answers it. */
export function slowChooser(): SerialLike & { answer: (port: SerialPortLike | null) => void } {
  return {
    answer: () => {},
    getPorts: async () => [],
    requestPort() {
      return new Promise((resolve, reject) => {
        this.answer = (port) => (port ? resolve(port) : reject(new DOMException('No port selected.', 'NotFoundError')));
      });
    },
  };
}
