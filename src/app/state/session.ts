import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import { type Progress, TimerError, type TimerErrorCode } from '../../client/index.js';
import type { TimerProgram } from '../../program/index.js';
import {
  availability,
  ConnectionError,
  type ConnectionErrorCode,
  choosePort,
  connect,
  rememberedPorts,
  type SerialPortLike,
  type Surroundings,
  type TimerConnection,
} from '../../serial/index.js';
import type { Draft, DraftStore } from '../storage/drafts.js';
import { Editor } from './editor.js';
import { LineLog } from './line-log.js';

/** Where the wire to a timer stands. */
export type Link =
  | { readonly status: 'off' }
  | { readonly status: 'choosing' }
  | { readonly status: 'opening'; readonly stop: AbortController }
  | { readonly status: 'on'; readonly connection: TimerConnection; readonly simulated: boolean };

/** Something to say to the pilot, by code: the sentence stands in messages/. */
export type Notice =
  | { readonly kind: 'connection'; readonly code: ConnectionErrorCode }
  | { readonly kind: 'timer'; readonly code: TimerErrorCode }
  | {
      readonly kind: 'note';
      readonly code: 'edits-restored' | 'edits-kept' | 'edits-moved' | 'edits-set-aside' | 'not-kept' | 'unexpected';
    };

/** A job on the wire that takes longer than a blink. */
export interface Job {
  readonly kind: 'read' | 'select';
  /** The memory that is being made current; null when the job is another. */
  readonly memory: number | null;
  readonly progress: Progress | null;
  readonly stop: AbortController;
}

export interface SessionOptions {
  readonly surroundings: Surroundings;
  readonly store: Pick<DraftStore, 'save' | 'remove' | 'load' | 'newest'>;
  readonly plugSimulated: (timerClass: 'Q' | 'B') => SerialPortLike;
}

/** One pilot, one wire, one program on the screen. */
export class Session {
  readonly editor = new Editor();
  readonly log = new LineLog();
  readonly link = signal<Link>({ status: 'off' }, { name: 'link' });
  readonly job = signal<Job | null>(null, { name: 'job' });
  readonly notice = signal<Notice | null>(null, { name: 'notice' });
  /** Propeller off or model held, timer not armed: asked once for each connection. */
  readonly safe = signal(false, { name: 'safe' });
  /** It is open how this timer writes its times: the pilot has to choose before they are written. */
  readonly byteOrderOpen = signal(false, { name: 'byteOrderOpen' });
  /** Whether the program on the screen is of the simulated timer. */
  readonly simulated = signal(false, { name: 'simulated' });
  /** A job, or the opening of a port, holds the wire. */
  readonly busy: ReadonlySignal<boolean> = computed(
    () => this.job.value !== null || this.link.value.status === 'choosing' || this.link.value.status === 'opening',
  );
  readonly connection: ReadonlySignal<TimerConnection | null> = computed(() =>
    this.link.value.status === 'on' ? this.link.value.connection : null,
  );
  /** Why there can be no wire here at all; null when there can. */
  readonly unavailable: 'insecure' | 'unsupported' | null;
  readonly #options: SessionOptions;
  /** What was typed since the page was opened, also where the browser keeps nothing. */
  readonly #drafts = new Map<string, Draft>();
  #saving: Promise<unknown> = Promise.resolve();
  #closing: Promise<unknown> = Promise.resolve();
  #savedKey: string | null = null;

  constructor(options: SessionOptions) {
    this.#options = options;
    this.unavailable = availability(options.surroundings);
  }

  /** Brings back what a reload or a crash interrupted, and keeps from now on what is typed. */
  async start(): Promise<void> {
    const draft = await this.#options.store.newest().catch(() => {
      this.notice.value = { kind: 'note', code: 'not-kept' };
      return undefined;
    });
    if (draft && !this.editor.working.value && this.editor.restore(draft)) {
      this.simulated.value = draft.simulated;
      this.notice.value ??= { kind: 'note', code: 'edits-restored' };
    }
    effect(() => this.#keep());
  }

  /**
   * Connects to the port that was used before if there is just one, else to the one that the pilot chooses. A timer that is connected
   * and has not been read is read.
   * @param choose asks for a port in any case.
   */
  async connect(choose = false): Promise<void> {
    const { serial } = this.#options.surroundings;
    if (!serial || this.busy.value) return;
    if (this.connection.value) return void (await this.read());
    this.notice.value = null;
    this.link.value = { status: 'choosing' };
    try {
      const [only, ...more] = choose ? [] : await rememberedPorts(serial);
      await this.#open(only && more.length === 0 ? only : await choosePort(serial), false);
    } catch (error) {
      this.#fail(error);
      this.link.value = { status: 'off' };
    }
  }

  async trySimulated(timerClass: 'Q' | 'B'): Promise<void> {
    if (this.busy.value) return;
    void this.disconnect();
    this.notice.value = null;
    await this.#open(this.#options.plugSimulated(timerClass), true);
  }

  /** Stops what is under way, lets the last request end and closes the port. What was typed stays on the screen. */
  async disconnect(): Promise<void> {
    const link = this.link.value;
    if (link.status === 'opening') return link.stop.abort();
    if (link.status !== 'on') return;
    this.job.value?.stop.abort();
    batch(() => {
      this.link.value = { status: 'off' };
      this.notice.value = null;
      if (!this.editor.dirty.value) this.editor.clear();
    });
    await this.#close(link.connection);
  }

  /**
   * Reads the current memory again. Edits stay.
   * @returns whether it was read.
   */
  async read(): Promise<boolean> {
    return await this.#run(null, async (connection, options) =>
      this.#show(await connection.client.readProgram(options)),
    );
  }

  /** Makes another memory current and reads it. Edits of the one that is left are kept for when it is read again. */
  async selectMemory(memory: number): Promise<void> {
    await this.#run(memory, async ({ client }, options) => {
      await client.selectMemory(memory, options);
      await this.#show(await client.readProgram(options));
    });
  }

  /** The pilot has chosen how the timer writes its times: they are read again that way. */
  async chooseByteOrder(bigEndianTimes: boolean): Promise<void> {
    if (this.busy.value) return;
    this.connection.value?.client.assume({ bigEndianTimes });
    await this.read();
  }

  /** Says that something went wrong, in the pilot's words. */
  report(error: unknown): void {
    this.#fail(error);
  }

  async #open(port: SerialPortLike, simulated: boolean): Promise<void> {
    const stop = new AbortController();
    this.link.value = { status: 'opening', stop };
    let connection: TimerConnection;
    await this.#closing;
    try {
      connection = await connect(port, { signal: stop.signal, onLine: this.log.add });
    } catch (error) {
      batch(() => {
        this.#fail(error);
        this.link.value = { status: 'off' };
      });
      return;
    }
    batch(() => {
      this.safe.value = false;
      this.byteOrderOpen.value = false;
      this.link.value = { status: 'on', connection, simulated };
    });
    void connection.lost.then((error) => this.#lost(connection, error));
    await this.read();
  }

  async #lost(connection: TimerConnection, error: ConnectionError): Promise<void> {
    if (this.connection.value !== connection) return;
    batch(() => {
      this.link.value = { status: 'off' };
      this.notice.value = { kind: 'connection', code: error.code };
    });
    await this.#close(connection);
  }

  /** Closes a port. Whoever opens one next waits for that: it may be the same. */
  async #close(connection: TimerConnection): Promise<void> {
    this.#closing = Promise.all([this.#closing, connection.close()]);
    await this.#closing;
  }

  async #run(
    memory: number | null,
    work: (
      connection: TimerConnection,
      options: { signal: AbortSignal; onProgress: (progress: Progress) => void },
    ) => Promise<void>,
  ): Promise<boolean> {
    const connection = this.connection.value;
    if (!connection || this.busy.value) return false;
    const stop = new AbortController();
    const begin = (progress: Progress | null): void => {
      this.job.value = { kind: memory === null ? 'read' : 'select', memory, progress, stop };
    };
    this.notice.value = null;
    begin(null);
    try {
      await work(connection, { signal: stop.signal, onProgress: begin });
      return true;
    } catch (error) {
      // A lost port says so itself, once.
      if (this.connection.value === connection) this.#fail(error);
      return false;
    } finally {
      this.job.value = null;
    }
  }

  /** Shows what was read, with the edits that belong to it. */
  async #show(read: TimerProgram): Promise<void> {
    const link = this.link.value;
    const simulated = link.status === 'on' && link.simulated;
    const key = draftKey(read, simulated);
    const { editor } = this;
    const before = editor.working.value;
    const same = before !== null && draftKey(before, this.simulated.value) === key;
    const setAside = before !== null && !same && editor.dirty.value;
    await this.#saving;
    const draft = same
      ? undefined
      : (this.#drafts.get(key) ?? (await this.#options.store.load(key).catch(() => undefined)));
    batch(() => {
      if (!same) editor.clear();
      if (draft && editor.restore(draft)) this.#savedKey = key;
      const moved = editor.rebase(read);
      this.byteOrderOpen.value = link.status === 'on' && link.connection.client.byteOrderOpen;
      this.simulated.value = simulated;
      if (moved) this.notice.value = { kind: 'note', code: 'edits-moved' };
      else if (draft && editor.dirty.value) this.notice.value = { kind: 'note', code: 'edits-kept' };
      else if (setAside) this.notice.value = { kind: 'note', code: 'edits-set-aside' };
    });
  }

  /** Keeps what is on the screen while it differs from the timer, and forgets it when it does not. */
  #keep(): void {
    const content = this.editor.snapshot();
    const dirty = this.editor.dirty.value;
    const simulated = this.simulated.value;
    if (!content) return;
    const key = draftKey(content.working, simulated);
    if (!dirty && this.#savedKey !== key) return;
    this.#savedKey = dirty ? key : null;
    const { store } = this.#options;
    const draft: Draft = { key, ...content, savedAt: Date.now(), simulated };
    if (dirty) this.#drafts.set(key, draft);
    else this.#drafts.delete(key);
    const work = dirty ? () => store.save(draft) : () => store.remove(key);
    this.#saving = this.#saving.then(work).catch(() => {
      this.notice.value = { kind: 'note', code: 'not-kept' };
    });
  }

  #fail(error: unknown): void {
    if (error instanceof ConnectionError) this.notice.value = { kind: 'connection', code: error.code };
    else if (!(error instanceof TimerError)) this.notice.value = { kind: 'note', code: 'unexpected' };
    else if (error.code !== 'aborted' && error.code !== 'closed')
      this.notice.value = { kind: 'timer', code: error.code };
  }
}

/** Where the work on a program is kept: by kind of timer and memory, since nothing tells one timer from another of its kind. */
function draftKey({ identity, memory }: TimerProgram, simulated: boolean): string {
  const { timerClass, firmware, functions, servos } = identity;
  return [simulated ? 'simulated' : 'timer', timerClass, firmware, functions, servos, memory ?? '?'].join('/');
}
