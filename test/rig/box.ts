import { type ChildProcessWithoutNullStreams, spawn } from 'node:child_process';
import { EventEmitter, once } from 'node:events';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { fromHex, toHex } from '../tools/bytes.js';
import { NAMESPACES } from './needs.js';

/** Where the page is served in every box: the origin that policy.json names. */
export const PAGE = 'http://127.0.0.1:4173/';

/** How the page has set the port. */
export interface PortSettings {
  readonly baudRate: number;
  readonly stopBits: number;
  readonly flowControl: 'none' | 'hardware';
}

/** What can be ordered of the box, see box.py. */
export type Order = 'grant' | 'plug' | 'unplug' | 'hangup' | 'mend' | 'hold' | 'release' | 'break' | 'parity';

interface BoxEvents {
  data: [bytes: Uint8Array];
  set: [settings: PortSettings];
  opened: [];
  closed: [];
}

/** The path of a program of the rig. */
export const beside = (name: string): string => fileURLToPath(new URL(name, import.meta.url));

/** The box (box.sh) and the line to its first process (box.py). */
export class Box extends EventEmitter<BoxEvents> {
  readonly #process: ChildProcessWithoutNullStreams;
  /** Orders that have not been done yet, oldest first. */
  readonly #done: { what: string; resolve: () => void; reject: (reason: Error) => void }[] = [];
  #errors = '';

  /** @param site the folder with the built page. */
  static async start(site: string): Promise<Box> {
    const box = new Box(spawn('unshare', [...NAMESPACES, beside('box.sh'), site]));
    await box.#until('ready');
    return box;
  }

  private constructor(process: ChildProcessWithoutNullStreams) {
    super();
    this.#process = process;
    createInterface(process.stdout).on('line', (line) => this.#hear(JSON.parse(line)));
    process.stderr.on('data', (text) => {
      this.#errors += text;
    });
    // Orders to a box that has ended fail by its end, told below.
    process.stdin.on('error', () => {});
    process.once('close', () => {
      for (const { reject } of this.#done.splice(0)) reject(this.#failure());
    });
  }

  /** The process that holds the namespaces. */
  get pid(): number {
    return this.#process.pid as number;
  }

  /** Settles when it is done. */
  order(what: Order, details: object = {}): Promise<void> {
    this.#tell({ do: what, ...details });
    return this.#until(what);
  }

  send(bytes: Uint8Array): void {
    this.#tell({ do: 'send', hex: toHex(bytes) });
  }

  /**
   * Ends it; nothing of it is left.
   * @throws Error when something in it had failed.
   */
  async close(): Promise<void> {
    if (!this.#ended) {
      const ended = once(this.#process, 'close');
      this.#process.stdin.end();
      await ended;
    }
    if (this.#process.exitCode !== 0) throw this.#failure();
  }

  get #ended(): boolean {
    return this.#process.exitCode !== null || this.#process.signalCode !== null;
  }

  #failure(): Error {
    return new Error(`The box has ended.\n${this.#errors}`);
  }

  #tell(order: object): void {
    this.#process.stdin.write(`${JSON.stringify(order)}\n`);
  }

  #until(what: string): Promise<void> {
    if (this.#ended) return Promise.reject(this.#failure());
    return new Promise((resolve, reject) => this.#done.push({ what, resolve, reject }));
  }

  #hear({ is, hex, ...more }: { is: string; hex?: string }): void {
    if (is === 'data') this.emit('data', fromHex(hex ?? ''));
    else if (is === 'set') this.emit('set', more as PortSettings);
    else if (is === 'opened' || is === 'closed') this.emit(is);
    else if (this.#done[0]?.what === is) this.#done.shift()?.resolve();
    else throw new Error(`The box says ${is}, which nobody asked for.`);
  }
}
