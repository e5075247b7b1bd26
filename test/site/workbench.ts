// Runs in the page before its own scripts, in the place of the browser's serial ports: an adapter, a timer in front of it, and a
// pilot's hands. Tests reach it as `window.workbench`; see app-page.ts.

import { MockSerial } from '../../src/mock-serial/index.js';
import type { CommandName } from '../../src/protocol/index.js';
import { Adapter } from '../serial/bench.js';

export interface WorkbenchOptions {
  readonly timerClass?: 'Q' | 'B';
  /** The page may use the port already, as after an earlier visit. */
  readonly granted?: boolean;
}

export class Workbench {
  readonly adapter: Adapter;
  readonly #serial: MockSerial;
  /** The first bytes that reach the page from now on that are to be damaged: how many are let through before, and how many. */
  #intact = Number.POSITIVE_INFINITY;

  constructor(serial: MockSerial, { timerClass = 'Q', granted = false }: WorkbenchOptions) {
    this.#serial = serial;
    this.adapter = new Adapter(serial, {
      identity: { timerClass },
      plug: {
        granted,
        timing: true,
        latency: 5,
        fault: { toPage: (byte) => (this.#intact-- === 0 ? [byte ^ 0x10, 0x45, 0x00] : [byte]) },
      },
    });
    serial.choose(this.adapter.port);
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

  /** Puts the timer to sleep right behind the answer to this request. */
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

  #at(name: CommandName, act: () => void): void {
    const { core } = this.adapter.timer;
    core.onAnswer = (request) => {
      if (request.name !== name) return;
      core.onAnswer = undefined;
      act();
    };
  }
}

declare global {
  interface Window {
    workbench: Workbench;
    workbenchOptions?: WorkbenchOptions;
  }
}

// Whether it was a click that asked cannot be told here: what drives the page counts as one. The rig uses the real chooser.
const serial = new MockSerial({ userActivation: true });
Object.defineProperty(navigator, 'serial', { value: serial, configurable: true });
window.workbench = new Workbench(serial, window.workbenchOptions ?? {});
