// Runs in the page before its own scripts, in the place of the browser's serial ports: an adapter, a timer in front of
// it, and a pilot's hands. Tests reach it as `window.workbench`; see app-page.ts.

import { type Fault, MockSerial } from '../../src/mock-serial/index.js';
import type { CommandName, Identity } from '../../src/protocol/index.js';
import type { TimerQuirks } from '../../src/simulator/index.js';
import { Adapter } from '../serial/bench.js';

export interface WorkbenchOptions {
  readonly timerClass?: 'Q' | 'B' | 'E';
  /** What the timer says of itself beside its class. */
  readonly identity?: Partial<Identity>;
  /** The page may use the port already, as after an earlier visit. */
  readonly granted?: boolean;
  readonly quirks?: TimerQuirks;
  /** Whether bytes take the time that they take on a real line: where speed is the subject. Default false. */
  readonly timing?: boolean;
  /** The share of all bytes, in both directions, that are lost, flipped or doubled. Default 0. */
  readonly damage?: number;
}

/** An adapter with the chip that most have. */
const INFO = { usbVendorId: 0x0403, usbProductId: 0x6001 };
/** What the timer holds while the page is loaded again. */
const HELD = 'workbench';

export class Workbench {
  readonly adapter: Adapter;
  readonly #serial: MockSerial;
  /**
   * The first bytes that reach the page from now on that are to be damaged: how many are let through before, and how
   * many.
   */
  #intact = Number.POSITIVE_INFINITY;

  constructor(
    serial: MockSerial,
    { timerClass = 'Q', granted = false, identity, timing = false, damage = 0, ...options }: WorkbenchOptions,
  ) {
    this.#serial = serial;
    const noise = { toPage: noiseOf(damage, 1), toDevice: noiseOf(damage, 2) };
    this.adapter = new Adapter(serial, {
      ...options,
      identity: { timerClass, ...identity },
      info: INFO,
      plug: {
        granted,
        timing,
        latency: timing ? 5 : 0,
        fault: {
          toPage: (byte, index) => (this.#intact-- === 0 ? [byte ^ 0x10, 0x45, 0x00] : noise.toPage(byte, index)),
          toDevice: noise.toDevice,
        },
      },
    });
    serial.choose(this.adapter.port);
    this.#outlive();
  }

  get opened() {
    return this.adapter.port.device.opened;
  }

  get content() {
    return this.adapter.timer.core.content;
  }

  /** The SET requests that the timer has answered. */
  get sets(): string[] {
    const { answered } = this.adapter.timer.core;
    return answered.map(({ name }) => name).filter((name) => name.startsWith('SET'));
  }

  dismissChooser(): void {
    this.#serial.choose(null);
  }

  chooseAdapter(): void {
    this.#serial.choose(this.adapter.port);
  }

  /** Another program takes the port, or gives it back. */
  setBusy(busy: boolean): void {
    this.adapter.port.device.busy = busy;
  }

  sleep(): void {
    this.adapter.timer.core.sleep();
  }

  press(): void {
    this.adapter.timer.core.press();
  }

  /** Pulls the plug when the timer has understood this request and before it answers. */
  unplugAt(name: CommandName): void {
    this.#at(name, () => this.adapter.unplug());
  }

  /** Puts the timer to sleep right after the answer to this request. */
  sleepAt(name: CommandName): void {
    this.#at(name, () => this.sleep());
  }

  replug(): void {
    this.adapter.replug();
  }

  /** Puts garbage in the place of a byte on its way to the page, so many bytes from now. */
  damageAfter(bytes: number): void {
    this.#intact = bytes;
  }

  /** A timer does not notice that a page is loaded again. */
  #outlive(): void {
    // The page from which every tab begins keeps nothing.
    if (origin === 'null') return;
    const { core } = this.adapter.timer;
    const { memories, memory } = JSON.parse(sessionStorage.getItem(HELD) ?? '{}') as Partial<typeof core>;
    if (memories) core.memories.splice(0, memories.length, ...memories);
    core.memory = memory ?? 0;
    addEventListener('pagehide', () => {
      sessionStorage.setItem(HELD, JSON.stringify({ memories: core.memories, memory: core.memory }));
    });
  }

  #at(name: CommandName, act: () => void): void {
    const { core } = this.adapter.timer;
    core.onAnswer = (request) => {
      if (request.name !== name) return;
      core.onAnswer = undefined;
      act();
    };
  }
}

/** Damage that is the same in every run. */
function noiseOf(share: number, seed: number): Fault {
  let state = seed;
  const next = (): number => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return state / 2 ** 32;
  };
  return (byte) => {
    if (next() >= share) return [byte];
    const kinds = [[], [byte ^ (1 << (8 * next()))], [byte, byte]];
    return kinds[Math.floor(3 * next())] ?? [];
  };
}

declare global {
  interface Window {
    workbench: Workbench;
    workbenchOptions?: WorkbenchOptions;
  }
}

// Whether it was a click that asked cannot be told here: what drives the page counts as one. The rig uses the real
// chooser.
const serial = new MockSerial({ userActivation: true });
Object.defineProperty(navigator, 'serial', { value: serial, configurable: true });
window.workbench = new Workbench(serial, window.workbenchOptions ?? {});
