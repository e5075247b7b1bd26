import { invalidState } from './errors.js';

/** What the handler attributes accept. */
export type EventHandler = ((event: Event) => unknown) | null;

const CAPTURING = 1;
const AT_TARGET = 2;
const BUBBLING = 3;

type ListenerArguments = Parameters<EventTarget['addEventListener']>;
type Listener = NonNullable<ListenerArguments[1]>;
type Options = ListenerArguments[2];

/** The browser's own events. */
const announced = new WeakSet<Event>();
/**
 * What an event shows to a listener at this point of its way. Only a listener sees it: a platform may read the same
 * properties while it passes the event to its listeners, as happy-dom does.
 */
const views = new WeakMap<Event, PropertyDescriptorMap>();

/** Fires an event of the browser's own at a port. It bubbles to Serial. */
export function announce(target: EventTarget, type: 'connect' | 'disconnect'): void {
  const event = new Event(type, { bubbles: true });
  announced.add(event);
  target.dispatchEvent(event);
}

/**
 * An event target with a parent, and with handlers for the standard's two events. Outside a document no event target of
 * the platform passes an event along. So this one keeps its listeners in targets of the platform, one for the way down
 * and one for the way up, and hands the event from one to the next, with the port as `target` all the way.
 */
export class ConnectionTarget extends EventTarget {
  readonly #parent: ConnectionTarget | null;
  readonly #onceNeverFires: boolean;
  readonly #down = new EventTarget();
  readonly #up = new EventTarget();
  /** Listeners that the browser's own events pass by: see `ChromiumWays.onceNeverFires`. */
  readonly #passedBy = new EventTarget();
  /** Each listener, called on this object and not on the target of the platform that keeps it. */
  readonly #bound = new WeakMap<object, (event: Event) => void>();
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
    const of = listenerOptions(options);
    const keeper = of.capture ? this.#down : of.once && this.#onceNeverFires ? this.#passedBy : this.#up;
    if (listener) keeper.addEventListener(type, this.#bind(listener), of);
  }

  /** The `removeEventListener()` method. Removing a listener that is not there does no harm. */
  override removeEventListener(type: string, listener: ListenerArguments[1] | null, options?: Options): void {
    const of = listenerOptions(options);
    if (!listener) return;
    for (const keeper of of.capture ? [this.#down] : [this.#up, this.#passedBy])
      keeper.removeEventListener(type, this.#bind(listener), of);
  }

  /** @throws InvalidStateError when the event is being dispatched already. */
  override dispatchEvent(event: Event): boolean {
    if (event.eventPhase > 0) throw invalidState('The event is being dispatched.');
    const path = this.#parent ? [this, this.#parent] : [this];
    let stopped = false;
    const stop = (): void => {
      stopped = true;
    };
    const stopAtOnce = (): void => {
      stop();
      Event.prototype.stopImmediatePropagation.call(event);
    };
    const target = { target: { value: this }, srcElement: { value: this } };
    const pass = (current: ConnectionTarget, phase: number, ...keepers: EventTarget[]): void => {
      views.set(event, {
        ...target,
        currentTarget: { value: current },
        eventPhase: { value: current === this ? AT_TARGET : phase },
        composedPath: { value: () => [...path] },
        stopPropagation: { value: stop },
        stopImmediatePropagation: { value: stopAtOnce },
        cancelBubble: { get: () => stopped, set: (value) => value && stop() },
      });
      for (const keeper of stopped ? [] : keepers) keeper.dispatchEvent(event);
    };
    for (const each of [...path].reverse()) pass(each, CAPTURING, each.#down);
    for (const each of event.bubbles ? path : [this])
      pass(each, BUBBLING, each.#up, ...(announced.has(event) ? [] : [each.#passedBy]));
    show(event, { ...target, composedPath: { value: () => [] } });
    return !event.defaultPrevented;
  }

  /** @throws TypeError when it can be no listener. */
  #bind(listener: Listener): (event: Event) => void {
    const bound =
      this.#bound.get(listener) ??
      ((event: Event): void => {
        const view = views.get(event) ?? {};
        show(event, view);
        try {
          if (typeof listener === 'function') listener.call(this, event);
          else listener.handleEvent(event);
        } finally {
          for (const name of Object.keys(view)) Reflect.deleteProperty(event, name);
        }
      });
    this.#bound.set(listener, bound);
    return bound;
  }

  /** A handler that replaces another keeps its place among the listeners. After null it comes last. */
  #setHandler(type: string, handler: EventHandler): void {
    const isSet = (typeof handler === 'object' && handler !== null) || typeof handler === 'function';
    this.#handlers.set(type, isSet ? handler : null);
    if (isSet) this.addEventListener(type, this.#callHandler);
    else this.removeEventListener(type, this.#callHandler);
  }

  // An object that cannot be called is a handler that does nothing, and false prevents the default: Web IDL.
  readonly #callHandler = (event: Event): void => {
    const handler = this.#handlers.get(event.type);
    if (typeof handler === 'function' && handler.call(this, event) === false) event.preventDefault();
  };
}

/** What Web IDL makes of the third argument: null and undefined stand for no options. */
function listenerOptions(options: Options | null): { capture?: boolean; once?: boolean } {
  return typeof options === 'object' ? { ...options } : { capture: Boolean(options) };
}

// An event has getters for these properties, which only the platform sets.
function show(event: Event, properties: PropertyDescriptorMap): void {
  for (const [name, property] of Object.entries(properties))
    Object.defineProperty(event, name, { ...property, configurable: true });
}
