import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import {
  type Change,
  checkProgram,
  differences,
  type Finding,
  fieldKey,
  hasErrors,
  type ProgramField,
  sameLayout,
  type TimerProgram,
  valueAt,
} from '../../program/index.js';
import { computedList } from './computed-list.js';
import { type Content, conflictsWith, followed, ontoReading, textsFor } from './content.js';
import { putBack, replaceAll, withValues } from './edit.js';
import { EMPTY_HISTORY, groupOf, type History, mapStates, type StepName, settle } from './history.js';
import { WorkingCopy } from './working-copy.js';

/** What can be put back into an editor: see {@link Editor.snapshot}. */
export interface EditorContent extends Content {
  readonly baseline: TimerProgram;
  readonly history?: History<Content> | undefined;
  /**
   * When the baseline was read, in milliseconds since 1970; null where that is not known. Not the editor's own: see
   * `Knowledge`.
   */
  readonly readAt?: number | null | undefined;
  /** When it was made, for one that was read from no timer: see {@link Editor.madeAt}. The baseline is how it began. */
  readonly madeAt?: number;
}

/** A program that was made on this device: when, in milliseconds since 1970, and how it began. */
interface Made {
  readonly at: number;
  readonly from: TimerProgram;
}

const NO_CONFLICTS: ReadonlyMap<string, Change> = new Map();

/**
 * The program on the screen. The baseline is what the timer last said, the working copy what the pilot wants;
 * everything else follows from the two.
 */
export class Editor extends WorkingCopy {
  readonly #baseline = signal<TimerProgram | null>(null, { name: 'baseline' });
  readonly #fresh = signal(false, { name: 'fresh' });
  readonly #shortDt = signal(6000, { name: 'shortDt' });
  readonly #moved = signal(NO_CONFLICTS, { name: 'moved' });
  /** Each has a time of its own, by which it is kept. */
  #lastMade = 0;
  readonly #made = signal<Made | null>(null, { name: 'made' });
  readonly #confirmed = signal<ReadonlySet<string>>(new Set(), { name: 'confirmed' });

  /** What the timer last said; null where nothing was read: there is no program, or it was made here. */
  readonly baseline: ReadonlySignal<TimerProgram | null> = this.#baseline;
  /** Whether the baseline is what a reading of this connection gave, whole, with nothing sent since. */
  readonly fresh: ReadonlySignal<boolean> = this.#fresh;
  /** The values that a write has changed and the reading back has confirmed, as long as that is on the screen. */
  readonly confirmed: ReadonlySignal<ReadonlySet<string>> = this.#confirmed;
  /** A DT below this is called short, in hundredths of a second. */
  readonly shortDt: ReadonlySignal<number> = this.#shortDt;

  /**
   * When the program was made, for one that was read from no timer, in milliseconds since 1970: nothing that stands in
   * it says anything about a timer. Null for one that was read.
   */
  readonly madeAt: ReadonlySignal<number | null> = computed(() => this.#made.value?.at ?? null);

  /** What differs from the timer. */
  readonly changes: ReadonlySignal<readonly Change[]> = computed(() => {
    const from = this.#baseline.value;
    const to = this.working.value;
    return from && to ? differences(from, to) : [];
  });
  readonly changed: ReadonlySignal<ReadonlyMap<string, Change>> = computed(
    () => new Map(this.changes.value.map((change) => [fieldKey(change.field), change])),
  );
  /**
   * What the timer held where it has changed under the pilot's edits, by field: `from` when they were made, `to` by the
   * last read.
   */
  readonly conflicts: ReadonlySignal<ReadonlyMap<string, Change>> = computed(
    () => new Map([...this.#moved.value].filter(([key]) => this.changed.value.has(key))),
  );
  readonly findings: ReadonlySignal<readonly Finding[]> = computedList(() => {
    const working = this.working.value;
    const baseline = this.#baseline.value ?? undefined;
    return working ? checkProgram(working, { baseline, shortDt: this.#shortDt.value }) : [];
  }, isSameFinding);
  /** Whether something stands in the way of a write. */
  readonly blocked: ReadonlySignal<boolean> = computed(
    () => this.unreadable.value.size > 0 || hasErrors(this.findings.value),
  );
  /** Whether there is anything that a reload would lose. */
  readonly dirty: ReadonlySignal<boolean> = computed(
    () => this.changes.value.length > 0 || this.unreadable.value.size > 0,
  );

  /** @param time hundredths of a second. */
  callShort(time: number): void {
    this.#shortDt.value = time;
  }

  /** Puts one field back to what the timer holds. */
  revert(field: ProgramField): void {
    this.revertFields({ code: 'revert', params: { field: fieldKey(field) } }, [field]);
  }

  /** Puts some fields back to what the timer holds, as one step. */
  revertFields(name: StepName, fields: readonly ProgramField[]): void {
    const baseline = this.#baseline.value;
    if (baseline) this.apply(putBack(name, baseline, fields));
  }

  /** Puts everything back to what the timer holds. */
  revertAll(): void {
    const baseline = this.#baseline.value;
    if (baseline) this.apply(replaceAll({ code: 'revert-all', params: {} }, baseline));
    this.#moved.value = NO_CONFLICTS;
  }

  /**
   * What was asked about a text is not answered: the text is taken back, or where more was done since then the field is
   * put back to what the timer holds.
   */
  takeBack(field: ProgramField): void {
    if (this.endsWithTyping(field)) this.undo();
    else this.revert(field);
  }

  /**
   * Escape in a field: what was typed last, or stepped last, since it was entered will not have been; if nothing was,
   * the field is put back to what the timer holds.
   */
  escape(field: ProgramField): void {
    const key = fieldKey(field);
    const taken = this.abandon(groupOf('type', key)) || this.abandon(groupOf('step', key));
    if (!taken) this.revert(field);
  }

  /**
   * The timer was read. Edits stay: they are taken over onto what the timer holds now.
   * @returns whether there are edits and the timer holds something else than when they were made, beyond what the pilot
   * wants anyway: a part of the edits may have been written.
   */
  rebase(read: TimerProgram): boolean {
    const before = this.#baseline.value;
    const content = this.content.value;
    if (!before || !content || !sameLayout(before.identity, read.identity)) {
      this.#begin(read, true, { working: read, texts: {} });
      return false;
    }
    const unforeseen = differences(before, read).filter(({ field, to }) => valueAt(content.working, field) !== to);
    const moved = this.changes.value.length > 0 && unforeseen.length > 0;
    batch(() => {
      if (moved) this.#moved.value = conflictsWith(this.#moved.value, differences(before, read));
      this.#baseline.value = read;
      this.#fresh.value = true;
      // Undo must not bring back what nobody typed; what the pilot wrote is no surprise and can be undone.
      const history = mapStates(this.history.value, (state) => followed(state, unforeseen, read));
      this.show(ontoReading(content, before, read), history);
    });
    return moved;
  }

  /** A write was read back: whatever was in conflict is decided. */
  wrote(held: TimerProgram): void {
    batch(() => {
      this.rebase(held);
      this.#moved.value = NO_CONFLICTS;
    });
  }

  /** Something was sent that may store: the timer may hold something else than what was read. */
  sent(): void {
    this.#fresh.value = false;
  }

  /** The result of a write comes, or goes with none: see {@link confirmed}. */
  confirm(fields: readonly ProgramField[]): void {
    this.#confirmed.value = new Set(fields.map(fieldKey));
  }

  /** The timer has acknowledged a value: it is what the timer holds, whatever the pilot wants by now. */
  acknowledge(field: ProgramField, value: number): void {
    const baseline = this.#baseline.value;
    if (baseline) this.#baseline.value = withValues(baseline, [{ field, value }]);
  }

  /** What has to be kept to come back to this point. */
  snapshot(): EditorContent | null {
    const made = this.#made.value;
    const baseline = made?.from ?? this.#baseline.value;
    const content = this.content.value;
    const kept = baseline && content && { baseline, ...content, history: this.history.value };
    return kept && made ? { ...kept, madeAt: made.at } : kept;
  }

  /**
   * Comes back to what was kept. Texts of fields that do not exist are dropped, and a history that does not fit.
   * @returns false, and nothing is changed, when the two programs do not fit together.
   */
  restore({ baseline, working, texts, of, backupOf, history = EMPTY_HISTORY, madeAt }: EditorContent): boolean {
    if (!sameLayout(baseline.identity, working.identity)) return false;
    const steps = [...history.past, ...history.future];
    const fits = steps.every(({ state }) => sameLayout(baseline.identity, state.working.identity));
    const isOf = of && sameLayout(of.saved.identity, working.identity);
    const content = { working, texts: textsFor(working, texts), of: isOf ? of : undefined, backupOf };
    const made = madeAt === undefined ? null : { at: madeAt, from: baseline };
    this.#begin(made ? null : baseline, false, content, fits ? settle(history) : EMPTY_HISTORY, made);
    return true;
  }

  /**
   * A new program, of no timer.
   * @param from the setting that it is opened from, or the model whose backup it is.
   */
  make(program: TimerProgram, from: Partial<Pick<Content, 'of' | 'backupOf'>> = {}): void {
    const at = Math.max(Date.now(), this.#lastMade + 1);
    this.#lastMade = at;
    this.#begin(null, false, { working: program, texts: {}, ...from }, EMPTY_HISTORY, { at, from: program });
  }

  /** Nothing on the screen. */
  clear(): void {
    this.#begin(null, this.#fresh.peek(), null);
  }

  #begin(
    baseline: TimerProgram | null,
    isFresh: boolean,
    content: Content | null,
    history: History<Content> = EMPTY_HISTORY,
    made: Made | null = null,
  ): void {
    batch(() => {
      this.#made.value = made;
      this.#baseline.value = baseline;
      this.#fresh.value = isFresh;
      this.#moved.value = NO_CONFLICTS;
      this.show(content, history);
    });
  }
}

function isSameFinding(a: Finding, b: Finding): boolean {
  if (a.code !== b.code || a.severity !== b.severity) return false;
  if ((a.field && fieldKey(a.field)) !== (b.field && fieldKey(b.field))) return false;
  return Object.keys({ ...a.params, ...b.params }).every((name) => a.params[name] === b.params[name]);
}
