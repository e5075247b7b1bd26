import { invalidState } from './errors.js';

/** What `addEventListener` accepts, declared so that no library of types is needed. */
export type Listener = ((event: Event) => void) | { handleEvent(event: Event): void };

/** What the handler attributes accept. */
export type EventHandler = ((event: Event) => void) | null;

/** The standard's AddEventListenerOptions dictionary. */
export interface ListenerOptions {
  /** Hears the event on its way down to the target. Default false. */
  readonly capture?: boolean;
  /** Is removed after the first event. Default false. */
  readonly once?: boolean;
  /** Accepted, without effect. */
  readonly passive?: boolean;
  /** Removes the listener when it aborts. */
  readonly signal?: AbortSignal;
}

interface Registration {
  readonly type: string;
  readonly listener: Listener;
  readonly capture: boolean;
  readonly once: boolean;
  removed: boolean;
}

const CAPTURING = 1;
const AT_TARGET = 2;
const BUBBLING = 3;

const dispatching = new WeakSet<Event>();
/** The browser's own events. */
const announced = new WeakSet<Event>();

/** Fires an event of the browser's own at a port. It bubbles to Serial. */
export function announce(target: EventTarget, type: 'connect' | 'disconnect'): void {
  const event = new Event(type, { bubbles: true });
  announced.add(event);
  target.dispatchEvent(event);
}

/**
 * An event target with a parent, and with handlers for the standard's two events. Outside a document, no built-in class
 * passes an event along. Here it goes from the parent down to the target, and up again if it bubbles, with the port as
 * `target` all the way.
 */
export class ConnectionTarget extends EventTarget {
  readonly #parent: ConnectionTarget | null;
  readonly #onceNeverFires: boolean;
  #registrations: Registration[] = [];
  readonly #handlers = new Map<string, { handler: unknown; readonly listener: Listener }>();

  /** @param onceNeverFires see `ChromiumWays`. */
  constructor(parent: ConnectionTarget | null, onceNeverFires = false) {
    super();
    this.#onceNeverFires = onceNeverFires;
    this.#parent = parent;
  }

  /** The `onconnect` attribute: called for the event `connect`, when a port comes that the site may use. */
  get onconnect(): EventHandler {
    return this.#handler('connect');
  }

  set onconnect(handler: EventHandler) {
    this.#setHandler('connect', handler);
  }

  /** The `ondisconnect` attribute: called for the event `disconnect`, when a port goes that the site may use. */
  get ondisconnect(): EventHandler {
    return this.#handler('disconnect');
  }

  set ondisconnect(handler: EventHandler) {
    this.#setHandler('disconnect', handler);
  }

  /** The `addEventListener()` method. A listener that is there already is not added again. */
  override addEventListener(type: string, listener: Listener | null, options?: boolean | ListenerOptions): void {
    const { capture = false, once = false, signal } = listenerOptions(options);
    if (!isListener(listener) || signal?.aborted || this.#find(type, listener, Boolean(capture))) return;
    this.#registrations.push({ type, listener, capture: Boolean(capture), once: Boolean(once), removed: false });
    signal?.addEventListener('abort', () => this.removeEventListener(type, listener, capture));
  }

  /** The `removeEventListener()` method. Removing a listener that is not there does no harm. */
  override removeEventListener(type: string, listener: Listener | null, options?: boolean | ListenerOptions): void {
    const { capture } = listenerOptions(options);
    const found = isListener(listener) && this.#find(type, listener, Boolean(capture));
    if (found) this.#remove(found);
  }

  /** @throws InvalidStateError when the event is being dispatched already. */
  override dispatchEvent(event: Event): boolean {
    if (dispatching.has(event)) throw invalidState('The event is being dispatched.');
    const ancestors: ConnectionTarget[] = [];
    for (let target = this.#parent; target; target = target.#parent) ancestors.push(target);
    const path = new EventPath(event, this, [this, ...ancestors]);
    dispatching.add(event);
    for (const ancestor of [...ancestors].reverse()) ancestor.#invoke(path, CAPTURING, true);
    this.#invoke(path, AT_TARGET, true);
    this.#invoke(path, AT_TARGET, false);
    if (event.bubbles) for (const ancestor of ancestors) ancestor.#invoke(path, BUBBLING, false);
    path.end();
    dispatching.delete(event);
    return !event.defaultPrevented;
  }

  #invoke(path: EventPath, phase: number, capture: boolean): void {
    if (path.stopped) return;
    path.reach(this, phase);
    for (const registration of [...this.#registrations]) {
      const { type, listener, once } = registration;
      if (type !== path.event.type || registration.capture !== capture || registration.removed) continue;
      if (once && this.#onceNeverFires && announced.has(path.event)) continue;
      if (once) this.#remove(registration);
      try {
        if (typeof listener === 'function') listener.call(this, path.event);
        else listener.handleEvent(path.event);
      } catch (error) {
        // A listener's error is reported like any uncaught one. It stops neither the other listeners nor the
        // dispatcher.
        queueMicrotask(() => {
          throw error;
        });
      }
      if (path.cutShort) return;
    }
  }

  #find(type: string, listener: Listener, capture: boolean): Registration | undefined {
    return this.#registrations.find((it) => it.type === type && it.listener === listener && it.capture === capture);
  }

  #remove(registration: Registration): void {
    registration.removed = true;
    this.#registrations = this.#registrations.filter((it) => it !== registration);
  }

  #handler(type: string): EventHandler {
    return (this.#handlers.get(type)?.handler ?? null) as EventHandler;
  }

  /** A handler that replaces another keeps its place among the listeners. After null it comes last. */
  #setHandler(type: string, handler: EventHandler): void {
    const former = this.#handlers.get(type);
    const isSet = (typeof handler === 'object' && handler !== null) || typeof handler === 'function';
    if (!isSet) {
      if (former) this.removeEventListener(type, former.listener);
      this.#handlers.delete(type);
    } else if (former) {
      former.handler = handler;
    } else {
      // A function of its own, because the page may have added the same handler as a listener, too.
      // An object that cannot be called is a handler that does nothing, and false prevents the default: Web IDL.
      const listener = (event: Event): void => {
        const current: unknown = this.#handlers.get(type)?.handler;
        if (typeof current === 'function' && current.call(this, event) === false) event.preventDefault();
      };
      this.#handlers.set(type, { handler, listener });
      this.addEventListener(type, listener);
    }
  }
}

/** What Web IDL makes of the third argument: null and undefined stand for no options. */
function listenerOptions(options: boolean | ListenerOptions | null | undefined): ListenerOptions {
  if (options === null || options === undefined) return {};
  return typeof options === 'object' || typeof options === 'function' ? options : { capture: Boolean(options) };
}

/** Whether there is a listener at all: null and undefined are none. @throws TypeError when it cannot be one. */
function isListener(listener: Listener | null | undefined): listener is Listener {
  if (listener === null || listener === undefined) return false;
  if (typeof listener === 'object' || typeof listener === 'function') return true;
  throw new TypeError('The listener must be a function or an object.');
}

/** One dispatch of an event: what the event shows on its way, and whether a listener has stopped it. */
class EventPath {
  readonly event: Event;
  stopped = false;
  /** Stopped at once: even the other listeners of the same target do not hear of it. */
  cutShort = false;

  constructor(event: Event, target: ConnectionTarget, path: readonly ConnectionTarget[]) {
    this.event = event;
    this.#show({
      target: { value: target },
      srcElement: { value: target },
      composedPath: { value: () => [...path] },
      stopPropagation: { value: () => this.#stop() },
      stopImmediatePropagation: { value: () => this.#stop(true) },
      cancelBubble: { get: () => this.stopped, set: (value) => value && this.#stop() },
    });
  }

  reach(target: ConnectionTarget, phase: number): void {
    this.#show({ currentTarget: { value: target }, eventPhase: { value: phase } });
  }

  end(): void {
    this.#show({ currentTarget: { value: null }, eventPhase: { value: 0 }, composedPath: { value: () => [] } });
  }

  #stop(cutShort = false): void {
    this.stopped = true;
    if (cutShort) this.cutShort = true;
  }

  // An event has getters for these properties, which only its own dispatch (without a parent) could set.
  #show(properties: PropertyDescriptorMap): void {
    for (const [name, property] of Object.entries(properties)) {
      Object.defineProperty(this.event, name, { ...property, configurable: true });
    }
  }
}
