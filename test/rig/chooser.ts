import { type ChildProcess, execFileSync, spawn } from 'node:child_process';
import { EventEmitter, once } from 'node:events';
import { env, execPath } from 'node:process';
import { createInterface } from 'node:readline';
import { type Box, beside } from './box.js';

/** The port of Chromium's UI DevTools; each box has a network of its own, so it is always free. */
export const UI_DEVTOOLS_PORT = 9223;

/** In pixels, from the upper left corner of the screen. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A screen that nobody looks at, since a browser's chooser opens on a screen only. */
export class Screen {
  readonly display: string;
  readonly #process: ChildProcess;

  static async start(): Promise<Screen> {
    // It takes a free display and says which, and ends with the last program that uses it.
    const args = ['-displayfd', '1', '-terminate', '-screen', '0', '1280x900x24', '-nolisten', 'tcp'];
    const process = spawn('Xvfb', args, { stdio: ['ignore', 'pipe', 'ignore'] });
    const ended = once(process, 'close').then(() => Promise.reject(new Error('Xvfb has ended.')));
    const [number] = await Promise.race([once(createInterface(process.stdout), 'line'), ended]);
    ended.catch(() => {}); // It ends some time.
    return new Screen(process, `:${number}`);
  }

  private constructor(process: ChildProcess, display: string) {
    this.#process = process;
    this.display = display;
  }

  press(key: string): void {
    this.#act('key', key);
  }

  /** Drags with the first button of the mouse, from place to place in so many steps. */
  drag(from: Place, to: Place, steps: number): void {
    const at = (step: number): string[] =>
      [from.x + ((to.x - from.x) * step) / steps, from.y + ((to.y - from.y) * step) / steps].map((each) =>
        String(Math.round(each)),
      );
    this.#act('mousemove', ...at(0), 'mousedown', '1');
    for (let step = 1; step <= steps; step++) this.#act('mousemove', ...at(step));
    this.#act('mouseup', '1');
  }

  #act(...orders: string[]): void {
    execFileSync('xdotool', orders, { env: { ...env, DISPLAY: this.display } });
  }

  async close(): Promise<void> {
    await end(this.#process);
  }
}

interface ChooserState {
  readonly shown: boolean;
  readonly rows: number;
  /** The row that is marked; -1 for none. */
  readonly selected: number;
}

/** The browser's own dialog for choosing a serial port, operated by keys as by a person. */
export class Chooser {
  readonly #screen: Screen;
  readonly #process: ChildProcess;
  /** What takes the marked port. */
  readonly #accept: string;
  readonly #changes = new EventEmitter<{ change: [] }>();
  #state: ChooserState = { shown: false, rows: 0, selected: -1 };

  static ofChromium(screen: Screen, box: Box): Chooser {
    const inBox = ['--target', String(box.pid), '--user', '--mount', '--net', '--preserve-credentials'];
    const watch = [execPath, '--experimental-websocket', beside('chooser-watch.js'), String(UI_DEVTOOLS_PORT)];
    return new Chooser(screen, ['nsenter', ...inBox, ...watch], 'Return');
  }

  static ofFirefox(screen: Screen): Chooser {
    return new Chooser(screen, [beside('chooser-watch.sh')], 'alt+a');
  }

  /** @param watch the command that tells what the dialog shows. */
  private constructor(screen: Screen, [program = '', ...args]: readonly string[], accept: string) {
    this.#screen = screen;
    this.#accept = accept;
    const surroundings = { ...env, DISPLAY: screen.display };
    const process = spawn(program, args, { env: surroundings, stdio: ['ignore', 'pipe', 'inherit'] });
    createInterface(process.stdout).on('line', (line) => {
      this.#state = JSON.parse(line);
      this.#changes.emit('change');
    });
    this.#process = process;
  }

  /** Waits until the dialog is up and lists so many ports. */
  async shows(rows: number): Promise<void> {
    if (!(await this.#until((state) => state.shown && state.rows === rows, 60_000))) {
      throw new Error(`The chooser must list ${rows} ports, but it is in this state: ${JSON.stringify(this.#state)}`);
    }
  }

  /** Takes the first port. */
  async choose(): Promise<void> {
    // In Chromium no port is marked at first, and the list has the keyboard only after a Tab or two.
    if (this.#state.selected !== 0) await this.#press(['Down', 'Tab'], ({ selected }) => selected === 0);
    await this.#press([this.#accept], ({ shown }) => !shown);
  }

  async dismiss(): Promise<void> {
    await this.#press(['Escape'], ({ shown }) => !shown);
  }

  async close(): Promise<void> {
    await end(this.#process);
  }

  /**
   * Presses these keys in turn until they have had their effect: for a moment after it comes up the dialog ignores all
   * keys.
   */
  async #press(keys: readonly string[], effect: (state: ChooserState) => boolean): Promise<void> {
    for (let tries = 0; tries < 10; tries++) {
      for (const key of keys) {
        this.#screen.press(key);
        if (await this.#until(effect, 1000)) return;
      }
    }
    throw new Error(`${keys.join(', ')} has no effect on the chooser: ${JSON.stringify(this.#state)}`);
  }

  async #until(reached: (state: ChooserState) => boolean, limit: number): Promise<boolean> {
    const signal = AbortSignal.timeout(limit);
    while (!reached(this.#state)) {
      const changed = await once(this.#changes, 'change', { signal }).catch(() => null);
      if (!changed) return false;
    }
    return true;
  }
}

async function end(process: ChildProcess): Promise<void> {
  if (process.exitCode !== null || process.signalCode !== null) return;
  const ended = once(process, 'close');
  process.kill();
  await ended;
}
