import { type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { attempt, type Service, service, tried } from './services.js';

/** The part of `navigator.locks` that the page uses. */
export type Locks = Service<'locks'>;

/** The part of `BroadcastChannel` that the page uses. */
export interface TabChannel {
  postMessage(message: unknown): void;
  addEventListener(type: 'message', listener: (event: { readonly data: unknown }) => void): void;
}

/** What a tab at work says about itself. */
export interface TabAtWork {
  /** Since when it has been open, in milliseconds since 1970. */
  readonly since: number;
  /** Whether a job has the wire, which is waited for. */
  readonly busy: boolean;
}

const NAME = 'sidus-timer';
/** How long a browser may take to say whether another tab is at work, in milliseconds. */
const ANSWER_WAIT = 1000;
/** How long the page before a reload may keep its right to work, in milliseconds. */
const RELOAD_WAIT = 500;
/** After this time without a word the other tab does not answer. Milliseconds. */
const SILENCE = 3000;

// The other tab may run another version of this page, so unknown messages are skipped.
const messageSchema = v.variant('kind', [
  v.object({ kind: v.literal('who') }),
  v.object({ kind: v.literal('give') }),
  v.object({ kind: v.literal('here'), since: v.pipe(v.number(), v.finite()), busy: v.boolean() }),
]);
type Message = v.InferOutput<typeof messageSchema>;

/** @throws the error of the browser when it refuses. */
function openChannel(): TabChannel | null {
  const Channel = service('BroadcastChannel');
  return Channel && new Channel(NAME);
}

/**
 * One tab of this page works at a time: the one that holds a lock of the browser. It holds it until it is left, also by
 * a crash. Any other tab waits for it, and can ask for it.
 */
export class OneTab {
  readonly #other = signal<TabAtWork | null>(null, { name: 'tabAtWork' });
  readonly #silent = signal(false, { name: 'tabSilent' });
  /** The tab at work, by its last word; null before that. */
  readonly other: ReadonlySignal<TabAtWork | null> = this.#other;
  /** Whether it was asked for its place and does not answer. */
  readonly silent: ReadonlySignal<boolean> = this.#silent;
  /** Settles once this tab has the right to work, if it had to wait for it. */
  readonly free: Promise<void>;
  readonly #locks: Locks | null;
  readonly #channel: TabChannel | null;
  #isFree: () => void = () => {};
  #release: () => void = () => {};
  readonly #queued = new AbortController();
  /** Whether the tab at work has said so since it was asked last. */
  #isBusy = false;
  #silence: ReturnType<typeof setTimeout> | undefined;
  #self: (() => TabAtWork) | null = null;
  #leave: () => Promise<void> = async () => {};

  /** @param open opens the channel between the tabs; null where the browser has none. */
  constructor(locks: Locks | null = service('locks'), open: () => TabChannel | null = openChannel) {
    this.#locks = locks;
    // Without a channel no tab can ask another one: that is said as a tab that does not answer.
    this.#channel = tried(open);
    tried(() => this.#channel?.addEventListener('message', ({ data }) => this.#hear(data)));
    this.free = new Promise((resolve) => {
      this.#isFree = resolve;
    });
  }

  /**
   * Asks for the right to work.
   * @returns `other`: another tab has it; see {@link free}. `unknown`: the browser does not tell, so this tab works.
   */
  async begin(): Promise<'alone' | 'other' | 'unknown'> {
    try {
      if (await attempt(() => this.#take({ ifAvailable: true }), ANSWER_WAIT)) return 'alone';
    } catch {
      return 'unknown';
    }
    // At the end of all tabs that wait.
    this.#take({ signal: this.#queued.signal }).then(this.#isFree, () => {});
    try {
      await attempt(() => this.free, RELOAD_WAIT);
      return 'alone';
    } catch {
      this.#say({ kind: 'who' });
      return 'other';
    }
  }

  /** Asks the tab at work for its place. It first waits for its job to end. */
  ask(): void {
    this.#silent.value = false;
    this.#isBusy = false;
    this.#say({ kind: 'give' });
    clearTimeout(this.#silence);
    this.#silence = setTimeout(() => {
      // A job may take long: asks again, to hear whether that tab is still there.
      if (this.#isBusy) this.ask();
      else this.#silent.value = true;
    }, SILENCE);
  }

  /**
   * This tab works from now on, and answers others.
   * @param busy whether a job has the wire.
   * @param leave another tab wants its place: ends this page. Called once.
   */
  work(busy: () => boolean, leave: () => Promise<void>): void {
    clearTimeout(this.#silence);
    const since = Date.now();
    this.#self = () => ({ since, busy: busy() });
    this.#leave = leave;
    // Those that wait for another one.
    this.#say({ kind: 'here', ...this.#self() });
  }

  /** The page is left: another tab may work. */
  end(): void {
    this.#queued.abort();
    this.#release();
  }

  /** @returns whether it was given. */
  #take(options: LockOptions): Promise<boolean> {
    return new Promise((resolve, reject) => {
      const held = new Promise<void>((release) => {
        this.#release = release;
      });
      const given = async (lock: unknown): Promise<void> => {
        resolve(lock !== null);
        if (lock !== null) await held;
      };
      if (this.#locks) this.#locks.request(NAME, options, given).catch(reject);
      else reject(new Error('no locks'));
    });
  }

  #hear(data: unknown): void {
    const parsed = v.safeParse(messageSchema, data);
    if (!parsed.success) return;
    const message = parsed.output;
    if (message.kind === 'here') {
      this.#silent.value = false;
      this.#other.value = message;
      this.#isBusy = message.busy;
    } else if (this.#self) {
      this.#say({ kind: 'here', ...this.#self() });
      const leave = this.#leave;
      if (message.kind === 'who') return;
      this.#leave = async () => {};
      void leave();
    }
  }

  #say(message: Message): void {
    tried(() => this.#channel?.postMessage(message));
  }
}
