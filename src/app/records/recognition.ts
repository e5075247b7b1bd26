import { batch, computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { Model, TimerProgram } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { CLASSES, newProgram } from '../editing/new-program.js';
import type { ModelRecord } from '../storage/index.js';
import type { FreshReading, Knowledge } from '../timer/knowledge.js';
import type { Link } from '../timer/link.js';
import { kindKey } from '../timer/record-keys.js';
import { emptyModel, type Library, newId } from './library.js';
import { type HeldOnce, type Recognised, recognise } from './recognition-rule.js';

/** The model of the connected timer. */
export type FoundModel =
  /** As the pilot has said on this connection. */
  | { readonly kind: 'said'; readonly model: Model }
  /** As its content shows. */
  | Recognised;

interface RecognitionParts {
  readonly library: Library;
  readonly knowledge: Knowledge;
  readonly link: Link;
}

const NOTHING: ReadonlyMap<number | null, HeldOnce> = new Map();
const NOBODY: ReadonlyMap<string, ModelRecord['verified']> = new Map();

/**
 * The model to which the connected timer belongs. Nothing on the wire says it: it follows from the timer's content and
 * what the models' timers are known to hold, or the pilot says it. When another timer takes its place during a
 * connection, the next reading shows it: the content is something that this page has neither read nor written. From
 * then on only that reading counts.
 */
export class Recognition {
  /** Null before the first reading, and until the models are loaded. */
  readonly found: ReadonlySignal<FoundModel | null>;
  /** The model of the connected timer; null when it is not known, or no timer is connected. */
  readonly model: ReadonlySignal<Model | null>;
  /** Whether there is a message or question about it that the pilot has not answered or closed. */
  readonly tells: ReadonlySignal<boolean>;
  /** Whether the pilot is choosing the model from a list. */
  readonly choosing: ReadonlySignal<boolean>;
  /** The models that the pilot can choose, in the order of the library. */
  readonly choices: ReadonlySignal<readonly Model[]>;
  /** Changes whenever the timer is, or may be, another one. */
  readonly timer: ReadonlySignal<number>;
  readonly #parts: RecognitionParts;
  /** The first reading of each memory on this connection, before this page has written into it. */
  readonly #evidence = signal<readonly TimerProgram[]>([], { name: 'evidence' });
  /** The latest readings. */
  readonly #held = signal(NOTHING, { name: 'heldNow' });
  /** What was known about the models before this connection has taught something new. */
  readonly #before = signal(NOBODY, { name: 'knownBefore' });
  readonly #said = signal<string | null>(null, { name: 'saidModel' });
  readonly #notNow = signal(false, { name: 'notNow' });
  readonly #timer = signal(0, { name: 'timer' });
  readonly #choosing = signal(false, { name: 'choosing' });

  constructor(parts: RecognitionParts) {
    this.#parts = parts;
    this.timer = this.#timer;
    const { library, knowledge } = parts;
    const { connection, simulated } = parts.link;
    const recognised = computed((): Recognised | null => {
      const read = this.#evidence.value;
      if (!connection.value || read.length === 0 || !library.models.loaded.value) return null;
      const isSimulated = simulated.value;
      const models = library.models.list.value.map((record) => ({
        model: record.model,
        verified: (this.#before.value.get(record.key) ?? record.verified).filter(
          (held) => (held.simulated ?? false) === isSimulated,
        ),
      }));
      return recognise(read, models, templatesFor(connection.value.identity));
    });
    this.found = computed(() => {
      const said = library.models.get(this.#said.value)?.model;
      return connection.value && said ? { kind: 'said', model: said } : recognised.value;
    });
    this.model = computed(() => {
      const found = this.found.value;
      return found && 'model' in found ? found.model : null;
    });
    this.tells = computed(() => {
      const kind = this.found.value?.kind;
      if (!kind || kind === 'said' || this.#notNow.value) return false;
      // A pilot without models is not asked for one.
      return kind !== 'unknown' || this.choices.value.length > 0;
    });
    this.choosing = computed(() => this.#choosing.value && connection.value !== null);
    this.choices = computed(() => {
      const identity = connection.value?.identity;
      if (!identity) return [];
      return library.models.list.value
        .filter((record) => canBe(record, identity, simulated.value))
        .map(({ model }) => model);
    });
    connection.subscribe((timer) => timer && this.#timerCame());
    knowledge.onRead((reading) => this.#wasRead(reading));
    effect(() => {
      const found = this.found.value;
      const held = this.#held.value;
      if (found?.kind === 'said' || found?.kind === 'same') void this.#learn(found.model.id, [...held.values()]);
    });
  }

  /** A timer was connected; it may be any. */
  #timerCame(): void {
    this.#forget([]);
    void this.#parts.library.models.load();
  }

  /** The pilot says that the timer belongs to this model. */
  say(model: Model): void {
    if (!this.#parts.link.connection.peek()) return;
    batch(() => {
      this.#said.value = model.id;
      this.#choosing.value = false;
    });
  }

  /** The pilot says that the timer belongs to a model that is not in the library yet. */
  async sayNew(name: string): Promise<void> {
    const identity = this.#parts.link.connection.peek()?.identity;
    if (!identity) return;
    const model = emptyModel(newId(), name, identity.timerClass);
    const kept = this.#parts.library.keepModel(model);
    this.say(model);
    await kept;
  }

  /** The pilot has read the message, or does not want the question: neither comes again on this connection. */
  notNow(): void {
    this.#notNow.value = true;
  }

  /** The pilot wants to say which model it is, for the first time or again. */
  choose(): void {
    this.#choosing.value = this.#parts.link.connection.peek() !== null;
  }

  /** Closes the list without a choice. */
  leave(): void {
    this.#choosing.value = false;
  }

  /**
   * A write was verified whose dialog had named a model that the timer is like. That counts as the pilot's word.
   * @param model the model that the dialog has named; null for none.
   */
  wrote(model: Model | null): void {
    const found = this.found.peek();
    if (model && found?.kind === 'like' && found.model.id === model.id) this.say(model);
  }

  #wasRead({ program, at, expected }: FreshReading): void {
    if (!this.#parts.link.connection.peek()) return;
    if (!expected) this.#forget([program]);
    const isKnown = this.#evidence.peek().some(({ memory }) => memory === program.memory);
    batch(() => {
      if (!isKnown && expected) this.#evidence.value = [...this.#evidence.peek(), program];
      this.#held.value = new Map(this.#held.peek()).set(program.memory, { program, at });
    });
  }

  #forget(evidence: readonly TimerProgram[]): void {
    batch(() => {
      this.#evidence.value = evidence;
      this.#held.value = NOTHING;
      this.#before.value = NOBODY;
      this.#said.value = null;
      this.#notNow.value = false;
      this.#choosing.value = false;
      this.#timer.value = this.#timer.peek() + 1;
    });
  }

  /** Keeps what a model's timer holds with the model, unless that is known already. */
  async #learn(key: string, held: readonly HeldOnce[]): Promise<void> {
    const { library, link } = this.#parts;
    const record = library.models.list.peek().find((each) => each.key === key);
    if (!record) return;
    const verified = withHeld(record.verified, held, link.simulated.peek());
    if (verified === record.verified) return;
    if (!this.#before.peek().has(key)) this.#before.value = new Map(this.#before.peek()).set(key, record.verified);
    await library.keepModel(record.model, { verified });
  }
}

/** What is known about the memories, updated with what they hold now; the same list if nothing is new. */
function withHeld(
  verified: ModelRecord['verified'],
  held: readonly HeldOnce[],
  simulated: boolean,
): ModelRecord['verified'] {
  const kind = held[0] && kindKey(held[0].program.identity, simulated);
  // A model with another timer holds nothing of what its timer before held.
  const ofTimer = verified.filter((each) => kindKey(each.program.identity, each.simulated ?? false) === kind);
  const news = held.filter(({ program }) => {
    const known = ofTimer.find((each) => each.program.memory === program.memory)?.program;
    return !known || JSON.stringify(known) !== JSON.stringify(program);
  });
  if (news.length === 0) return verified;
  const rest = ofTimer.filter(({ program }) => !news.some((each) => each.program.memory === program.memory));
  return [...rest, ...news.map((each) => (simulated ? { ...each, simulated } : each))];
}

/** Whether the pilot may say that a timer belongs to this model. Simulated and real timers never mix. */
function canBe({ model, verified }: ModelRecord, { timerClass }: Identity, simulated: boolean): boolean {
  if (model.archived || (model.timerClass !== null && model.timerClass !== timerClass)) return false;
  return verified.every((held) => (held.simulated ?? false) === simulated);
}

/** What a timer may hold before anybody has trimmed it. */
function templatesFor({ timerClass, functions, servos }: Identity): readonly TimerProgram[] {
  const known = CLASSES.find((each) => each === timerClass);
  if (!known) return [];
  return (['usual', 'nothing'] as const).map((from) => newProgram({ timerClass: known, functions, servos, from }));
}
