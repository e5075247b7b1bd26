import { invalidState } from './errors.js';

/** What the handler attributes accept. */
export type EventHandler = ((event: Event) => unknown) | null;

const CAPTURING = 1;
const AT_TARGET = 2;
const BUBBLING = 3;

type ListenerArguments = Parameters<EventTarget['addEventListener']>;
type Options = ListenerArguments[2];

interface Entry {
  readonly type: string;
  readonly listener: NonNullable<ListenerArguments[1]>;
  readonly capture: boolean;
  readonly once: boolean;
}

/** The browser's own events. */
const announced = new WeakSet<Event>();

/** Fires an event of the browser's own at a port. It bubbles to Serial. */
export function announce(target: EventTarget, type: 'connect' | 'disconnect'): void {
  const event = new Event(type, { bubbles: true });
  announced.add(event);
  target.dispatchEvent(event);
}

/**
 * An event target with a parent, and with handlers for the standard's two events. Outside a document no event target of
 * the platform passes an event along. So this one does it by the steps of the DOM standard.
 */
export class ConnectionTarget extends EventTarget {
  readonly #parent: ConnectionTarget | null;
  readonly #onceNeverFires: boolean;
  #entries: readonly Entry[] = [];
  readonly #handlers = new Map<string, EventHandler>();

  /** @param onceNeverFires see `ChromiumWays`. */
  constructor(parent: ConnectionTarget | null, onceNeverFires = false) {
    super();
    this.#onceNeverFires = onceNeverFires;
    this.#parent = parent;
  }

  /** The `onconnect` attribute: called for the event `connect`, when a port comes that the site may use. */
  get onconnect(): EventHandler {
    return this.#handlers.get('connect') ?? null;
  }

  set onconnect(handler: EventHandler) {
    this.#setHandler('connect', handler);
  }

  /** The `ondisconnect` attribute: called for the event `disconnect`, when a port goes that the site may use. */
  get ondisconnect(): EventHandler {
    return this.#handlers.get('disconnect') ?? null;
  }

  set ondisconnect(handler: EventHandler) {
    this.#setHandler('disconnect', handler);
  }

  /** The `addEventListener()` method. A listener that is there already is not added again. */
  override addEventListener(
    type: 'connect' | 'disconnect',
    listener: (this: this, event: Event) => void,
    options?: Options,
  ): void;
  override addEventListener(type: string, listener: ListenerArguments[1] | null, options?: Options): void;
  override addEventListener(type: string, listener: ListenerArguments[1] | null, options?: Options): void {
    if (listener === null || listener === undefined) return;
    if (!isObject(listener)) throw new TypeError('A listener must be a function or an object.');
    const { capture = false, once = false, signal } = listenerOptions(options);
    if (signal?.aborted || this.#find(type, listener, capture)) return;
    this.#entries = [...this.#entries, { type, listener, capture, once }];
    signal?.addEventListener('abort', () => this.removeEventListener(type, listener, capture));
  }

  /** The `removeEventListener()` method. Removing a listener that is not there does no harm. */
  override removeEventListener(
    type: 'connect' | 'disconnect',
    listener: (this: this, event: Event) => void,
    options?: Options,
  ): void;
  override removeEventListener(type: string, listener: ListenerArguments[1] | null, options?: Options): void;
  override removeEventListener(type: string, listener: ListenerArguments[1] | null, options?: Options): void {
    const found = this.#find(type, listener, listenerOptions(options).capture ?? false);
    this.#entries = this.#entries.filter((entry) => entry !== found);
  }

  /** @throws InvalidStateError when the event is being dispatched already. */
  override dispatchEvent(event: Event): boolean {
    if (!(event instanceof Event)) throw new TypeError('The argument is no Event.');
    if (event.eventPhase > 0) throw invalidState('The event is being dispatched.');
    const path = this.#parent ? [this, this.#parent] : [this];
    let current: ConnectionTarget | null = null;
    let phase = 0;
    let isStopped = false;
    let isStoppedAtOnce = false;
    const stop = (): void => {
      isStopped = true;
    };
    const shown: PropertyDescriptorMap = {
      target: { value: this },
      srcElement: { value: this },
      currentTarget: { get: () => current },
      eventPhase: { get: () => phase },
      composedPath: { value: () => (current ? [...path] : []) },
      stopPropagation: { value: stop },
      stopImmediatePropagation: { value: () => (isStopped = isStoppedAtOnce = true) },
      cancelBubble: { get: () => isStopped, set: (value) => value && stop() },
    };
    // An event has getters for these properties, which only the platform sets.
    for (const [name, property] of Object.entries(shown))
      Object.defineProperty(event, name, { ...property, configurable: true });
    const pass = (at: ConnectionTarget, capture: boolean): void => {
      if (isStopped) return;
      current = at;
      phase = at === this ? AT_TARGET : capture ? CAPTURING : BUBBLING;
      for (const entry of at.#entries) {
        const isMeant = entry.type === event.type && entry.capture === capture && at.#entries.includes(entry);
        if (isMeant && !isStoppedAtOnce) at.#hear(event, entry);
      }
    };
    for (const each of [...path].reverse()) pass(each, true);
    for (const each of event.bubbles ? path : [this]) pass(each, false);
    current = null;
    phase = 0;
    return !event.defaultPrevented;
  }

  #hear(event: Event, entry: Entry): void {
    if (entry.once && this.#onceNeverFires && announced.has(event)) return;
    const { listener } = entry;
    if (entry.once) this.#entries = this.#entries.filter((each) => each !== entry);
    try {
      if (typeof listener === 'function') listener.call(this, event);
      else listener.handleEvent(event);
    } catch (error) {
      // Like any error that nobody catches. The event goes on.
      queueMicrotask(() => {
        throw error;
      });
    }
  }

  #find(type: string, listener: unknown, capture: boolean): Entry | undefined {
    return this.#entries.find((it) => it.type === type && it.listener === listener && it.capture === capture);
  }

  /** A handler that replaces another keeps its place among the listeners. After null it comes last. */
  #setHandler(type: string, handler: EventHandler): void {
    this.#handlers.set(type, isObject(handler) ? handler : null);
    if (isObject(handler)) this.addEventListener(type, this.#callHandler);
    else this.removeEventListener(type, this.#callHandler);
  }

  // An object that cannot be called is a handler that does nothing, and false prevents the default: Web IDL.
  readonly #callHandler = (event: Event): void => {
    const handler = this.#handlers.get(event.type);
    if (typeof handler === 'function' && handler.call(this, event) === false) event.preventDefault();
  };
}

/** What Web IDL makes of the third argument: null and undefined stand for no options. */
function listenerOptions(options: Options | null): AddEventListenerOptions {
  return typeof options === 'object' ? { ...options } : { capture: Boolean(options) };
}

function isObject(value: unknown): boolean {
  return typeof value === 'function' || (typeof value === 'object' && value !== null);
}
