import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { env } from 'node:process';
import { type BrowserContext, chromium, firefox, type Page } from 'playwright';
import { expect, inject, onTestFinished } from 'vitest';
import { COMMANDS, type CommandName, type Frame, FrameDecoder } from '../../src/protocol/index.js';
import { VirtualTimer, type VirtualTimerOptions } from '../../src/simulator/index.js';
import { browserArgs } from '../tools/browser.js';
import { Box, beside, PAGE, type PortSettings } from './box.js';
import { Chooser, Screen, UI_DEVTOOLS_PORT } from './chooser.js';

export interface RigOptions {
  /** The timer behind the port. */
  readonly timer?: VirtualTimerOptions;
  /** The only rate, in bits a second, at which the timer understands and is understood. Default: any. */
  readonly rate?: number;
  /** The browser's chooser must be operated: nothing lets the page use the port unasked. */
  readonly chooser?: boolean;
  /** What the pilot of this test asks for of the commands that are never sent unasked. */
  readonly asks?: readonly CommandName[];
}

/** Commands that free the motor, move a servo or do nobody knows what: no way through the page sends them unasked. */
const NEVER_SENT: readonly number[] = [COMMANDS.UNLOCK, COMMANDS.JUMP2, COMMANDS.MOVETOFUNC].map(
  ({ request }) => request,
);

export type Direction = 'fromPage' | 'toPage';

/** A whole frame on the line. */
export interface Heard extends Frame {
  readonly direction: Direction;
  /** When its last byte was heard, in milliseconds. */
  readonly at: number;
}

/** The built page in an unmodified browser, whose Web Serial leads to a pty, behind which a virtual timer answers. */
export class Rig {
  readonly timer: VirtualTimer;
  /** All bytes that have passed, in each direction. */
  readonly passed: Readonly<Record<Direction, number[]>> = { fromPage: [], toPage: [] };
  /** Every frame, in the order in which they end, also those that did not reach the other side. */
  readonly frames: Heard[] = [];
  /** How the page set the port when bytes last came from it. */
  settings: PortSettings | undefined;
  /** How often the page has opened and closed the port. */
  readonly sessions = { opened: 0, closed: 0 };
  readonly #box: Box;
  readonly #context: BrowserContext;
  readonly #screen: Screen | undefined;
  readonly #chooser: Chooser | undefined;
  /** The page asks for the port, and the rig chooses, each time it is loaded: Firefox has no policy for that. */
  readonly #asksFirst: boolean;
  readonly #toTimer: WritableStreamDefaultWriter<Uint8Array>;
  readonly #rate: number | undefined;
  #plugged = false;
  #covered = false;
  #fuse: { direction: Direction; left: number; blow: () => void } | undefined;

  /** For one test: ends with it, and fails it when the page reports an error or has sent what it never may unasked. */
  static async start(options: RigOptions = {}): Promise<Rig> {
    const disposals: (() => Promise<void> | undefined)[] = [];
    const faults: string[] = [];
    onTestFinished(async () => {
      for (const dispose of disposals.reverse()) {
        await dispose()?.catch((error: unknown) => faults.push(String(error)));
      }
      expect(faults, 'the page or the rig reported errors').toEqual([]);
    });
    const box = await Box.start(inject('builtPage'));
    disposals.push(() => box.close());
    const isFirefox = inject('modem') !== undefined;
    if (!options.chooser) await box.order('grant');
    const screen = options.chooser || isFirefox ? await Screen.start() : undefined;
    disposals.push(() => screen?.close());
    const home = await mkdtemp(join(tmpdir(), 'sidus-profile-'));
    disposals.push(() => rm(home, { recursive: true, force: true, maxRetries: 5 }));
    const context = await (isFirefox ? launchFirefox : launchChromium)(box, home, screen);
    context.setDefaultTimeout(60_000);
    disposals.push(() => context.close());
    const chooser = screen && (isFirefox ? Chooser.ofFirefox(screen) : Chooser.ofChromium(screen, box));
    disposals.push(() => chooser?.close());
    // Errors of the page, and what its content security policy stopped.
    context.on('weberror', (error) => faults.push(error.error().message));
    context.on('console', (message) => message.type() === 'error' && faults.push(message.text()));
    const rig = new Rig(box, context, { screen, chooser }, options);
    disposals.push(async () => {
      const asked: readonly number[] = (options.asks ?? []).map((name) => COMMANDS[name].request);
      const sent = rig.requests.filter((code) => NEVER_SENT.includes(code) && !asked.includes(code));
      if (sent.length > 0) throw new Error(`The page has sent commands that it must never send unasked: ${sent}.`);
    });
    await rig.plug();
    return rig;
  }

  private constructor(
    box: Box,
    context: BrowserContext,
    { screen, chooser }: { readonly screen: Screen | undefined; readonly chooser: Chooser | undefined },
    { timer, rate, chooser: isAsked }: RigOptions,
  ) {
    this.#box = box;
    this.#context = context;
    this.#screen = screen;
    this.#chooser = chooser;
    this.#asksFirst = chooser !== undefined && !isAsked;
    this.timer = new VirtualTimer(timer);
    this.#rate = rate;
    this.#toTimer = this.timer.writable.getWriter();
    const listen = (direction: Direction): ((bytes: Uint8Array) => void) => {
      const decoder = new FrameDecoder();
      box.on('opened', () => decoder.idle());
      return (bytes) => {
        for (const frame of decoder.push(bytes)) this.frames.push({ ...frame, direction, at: performance.now() });
      };
    };
    box.on('data', listen('fromPage'));
    box.on('data', (bytes) => this.#pass('fromPage', bytes, (passed) => void this.#toTimer.write(passed)));
    box.on('set', (settings) => {
      this.settings = settings;
    });
    box.on('opened', () => this.sessions.opened++);
    box.on('closed', () => this.sessions.closed++);
    const heardBack = listen('toPage');
    const answer = (bytes: Uint8Array): void => {
      heardBack(bytes);
      this.#pass('toPage', bytes, (passed) => box.send(passed));
    };
    void this.timer.readable.pipeTo(new WritableStream({ write: answer }));
  }

  /** The command byte of every frame that the page has sent, also of those that did not reach the timer. */
  get requests(): number[] {
    return this.frames.filter(({ direction }) => direction === 'fromPage').map(({ code }) => code);
  }

  /** The page in a new tab; in the only one at first. */
  async open(): Promise<Page> {
    const [blank] = this.#context.pages().filter((page) => page.url() === 'about:blank');
    const page = blank ?? (await this.#context.newPage());
    await page.goto(PAGE);
    if (this.#asksFirst) {
      const chosen = page.evaluate(async () => void (await navigator.serial.requestPort()));
      await this.chooser.shows(1);
      await this.chooser.choose();
      await chosen;
    }
    return page;
  }

  get chooser(): Chooser {
    if (!this.#chooser) throw new Error('This rig was started without a chooser.');
    return this.#chooser;
  }

  /** The screen on which Chromium is, with its mouse. */
  get screen(): Screen {
    if (!this.#screen) throw new Error('This rig was started without a chooser.');
    return this.#screen;
  }

  /** @param number of the name that the machine gives it, ttyUSB0 and so on. */
  async plug(number = 0): Promise<void> {
    this.#plugged = true;
    await this.#box.order('plug', { number });
  }

  async unplug(): Promise<void> {
    this.#plugged = false;
    await this.#box.order('unplug');
  }

  /**
   * Pulls the plug as soon as this many more bytes have passed in this direction: the next one does not arrive any
   * more.
   * @returns a promise that settles when it is out.
   */
  unplugAfter(bytes: number, direction: Direction): Promise<void> {
    return new Promise((out) => {
      this.#fuse = { direction, left: bytes, blow: () => void this.unplug().then(out) };
    });
  }

  /**
   * Covers the infrared head as soon as this many more bytes have passed in this direction: no more pass in any, until
   * {@link uncover}.
   * @returns a promise that settles when it is covered.
   */
  coverAfter(bytes: number, direction: Direction): Promise<void> {
    return new Promise((covered) => {
      const blow = (): void => {
        this.#covered = true;
        covered();
      };
      this.#fuse = { direction, left: bytes, blow };
    });
  }

  uncover(): void {
    this.#covered = false;
  }

  /** The adapter fails, while for the machine it is still there. */
  async breakAdapter(): Promise<void> {
    this.#plugged = false;
    await this.#box.order('hangup');
  }

  /** The adapter works again, and nothing tells so. */
  async mendAdapter(): Promise<void> {
    this.#plugged = true;
    await this.#box.order('mend');
  }

  /** Another program has the port, while `work` runs. */
  async whileHeld(work: () => Promise<void>): Promise<void> {
    await this.#box.order('hold');
    await work();
    await this.#box.order('release');
  }

  #pass(direction: Direction, bytes: Uint8Array, onward: (bytes: Uint8Array) => void): void {
    if (!this.#plugged || this.#covered) return;
    if (this.#rate !== undefined && this.settings?.baudRate !== this.#rate) return;
    const fuse = this.#fuse?.direction === direction ? this.#fuse : undefined;
    const passed = bytes.subarray(0, fuse?.left);
    this.passed[direction].push(...passed);
    if (passed.length > 0) onward(passed);
    if (!fuse) return;
    fuse.left -= passed.length;
    if (fuse.left > 0) return;
    this.#fuse = undefined;
    fuse.blow();
  }
}

/** Starts Chromium in the box, with a home of its own. */
export function launchChromium(box: Box, home: string, screen: Screen | undefined): Promise<BrowserContext> {
  return chromium.launchPersistentContext(join(home, 'profile'), {
    executablePath: beside('chromium.sh'),
    headless: !screen,
    // In the box this is root, for whom Chromium has no sandbox.
    chromiumSandbox: false,
    env: surroundings(box, home, screen),
    args: [...browserArgs, ...(screen ? [`--enable-ui-devtools=${UI_DEVTOOLS_PORT}`, '--window-position=0,0'] : [])],
  });
}

/** Starts Firefox in the box, with a home of its own, on a screen: Playwright drives it by WebDriver BiDi. */
function launchFirefox(box: Box, home: string, screen: Screen | undefined): Promise<BrowserContext> {
  return firefox.launchPersistentContext(join(home, 'profile'), {
    channel: 'moz-firefox',
    executablePath: beside('firefox.py'),
    headless: false,
    env: { ...surroundings(box, home, screen), RIG_MODEM: inject('modem') ?? '' },
    viewport: null,
  });
}

function surroundings(box: Box, home: string, screen: Screen | undefined): Record<string, string> {
  const own = { HOME: home, RIG_BOX: String(box.pid), ...(screen && { DISPLAY: screen.display }) };
  return { ...(env as Record<string, string>), ...own };
}
