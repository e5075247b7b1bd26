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
import { type Content, conflictsWith, followed, isJust, ontoReading, ownerOf, textsFor } from './content.js';
import { type Edit, type Owner, putBack, replaceAll, withValues } from './edit.js';
import { cellKey, type GridField } from './grid.js';
import { EMPTY_HISTORY, groupOf, type History, mapStates, type StepName, settle } from './history.js';
import { MINUTE } from './units.js';
import { WorkingCopy } from './working-copy.js';

/** What can be put back into an editor; see {@link Editor.snapshot}. */
export interface EditorContent extends Content {
  readonly baseline: TimerProgram;
  readonly history?: History<Content> | undefined;
  /**
   * When the baseline was read, in milliseconds since 1970; null when that is not known.
   * `Knowledge` owns it, not the editor.
   */
  readonly readAt?: number | null | undefined;
  /** When a program that was read from no timer was made; see {@link Editor.madeAt}. Its baseline is how it began. */
  readonly madeAt?: number;
}

/** A program that was made on this device: when (milliseconds since 1970), and its first values. */
interface Made {
  readonly at: number;
  readonly from: TimerProgram;
}

const NO_CONFLICTS: ReadonlyMap<string, Change> = new Map();
const UNOWNED: Owner = { of: undefined, backupOf: undefined };

/**
 * The program on the screen. The baseline is what the timer last said; the working copy is what the pilot wants.
 * Everything else follows from these two.
 */
export class Editor extends WorkingCopy {
  readonly #baseline = signal<TimerProgram | null>(null, { name: 'baseline' });
  readonly #heldOf = signal<Owner>(UNOWNED, { name: 'heldOf' });
  readonly #fresh = signal(false, { name: 'fresh' });
  readonly #shortDt = signal(MINUTE, { name: 'shortDt' });
  readonly #moved = signal(NO_CONFLICTS, { name: 'moved' });
  /** No two programs have the same time, because the time is their key in the storage. */
  #lastMade = 0;
  readonly #made = signal<Made | null>(null, { name: 'made' });
  readonly #confirmed = signal<ReadonlySet<string>>(new Set(), { name: 'confirmed' });

  /** What the timer last said; null when nothing was read: there is no program, or it was made here. */
  readonly baseline: ReadonlySignal<TimerProgram | null> = this.#baseline;
  /** Whose values the baseline has: of nothing that is kept here, unless they were on the screen when it was read. */
  readonly heldOf: ReadonlySignal<Owner> = this.#heldOf;
  /** Whether the baseline is a whole reading from this connection, with nothing sent since. */
  readonly fresh: ReadonlySignal<boolean> = this.#fresh;
  /** The fields that a write has changed and the read back has confirmed, while they stay on the screen. */
  readonly confirmed: ReadonlySignal<ReadonlySet<string>> = this.#confirmed;
  /** A DT below this counts as short, in hundredths of a second. */
  readonly shortDt: ReadonlySignal<number> = this.#shortDt;

  /**
   * When a program that was read from no timer was made, in milliseconds since 1970: it says nothing about any timer.
   * Null for one that was read.
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
   * Values of the timer that have changed under the pilot's edits, by field. `from`: when the edits were made. `to`: in
   * the last reading.
   */
  readonly conflicts: ReadonlySignal<ReadonlyMap<string, Change>> = computed(
    () => new Map([...this.#moved.value].filter(([key]) => this.changed.value.has(key))),
  );
  /** Whether the timer held something else under the pilot's edits than when they were made. */
  readonly isMoved: ReadonlySignal<boolean> = computed(() => this.#moved.value.size > 0);
  readonly findings: ReadonlySignal<readonly Finding[]> = computedList(() => {
    const working = this.working.value;
    const baseline = this.#baseline.value ?? undefined;
    return working ? checkProgram(working, { baseline, shortDt: this.#shortDt.value }) : [];
  }, isSameFinding);
  /** The findings about fields, by field. */
  readonly findingsAt: ReadonlySignal<ReadonlyMap<string, readonly Finding[]>> = computed(() => {
    const found = new Map<string, Finding[]>();
    for (const finding of this.findings.value) {
      if (!finding.field) continue;
      const key = fieldKey(finding.field);
      found.set(key, [...(found.get(key) ?? []), finding]);
    }
    return found;
  });
  /** Whether something prevents a write. */
  readonly blocked: ReadonlySignal<boolean> = computed(
    () => this.unreadable.value.size > 0 || hasErrors(this.findings.value),
  );
  /** Whether a reload would lose anything. */
  readonly dirty: ReadonlySignal<boolean> = computed(
    () => this.changes.value.length > 0 || this.unreadable.value.size > 0,
  );

  /** @param time hundredths of a second. */
  callShort(time: number): void {
    this.#shortDt.value = time;
  }

  /** Puts one field back to what the timer holds. */
  revert(field: ProgramField): void {
    this.revertFields({ code: 'change', params: { field: fieldKey(field) } }, [field]);
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
   * The pilot does not answer what a text means: takes the text back. If more was done since then, puts the field back
   * to what the timer holds.
   */
  takeBack(field: ProgramField): void {
    if (this.endsWithTyping(field)) this.undo();
    else this.revert(field);
  }

  /** Takes back what was typed or stepped in a field since it was entered. @returns whether anything was. */
  abandonAt(field: ProgramField | GridField): boolean {
    const key = cellKey(field);
    return this.abandon(groupOf('type', key)) || this.abandon(groupOf('step', key));
  }

  /**
   * The timer was read again. Edits stay, now on top of what the timer holds.
   * @returns whether the timer has changed under the edits, other than to what the pilot wants anyway. A part of the
   * edits may have been written.
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
      // Undo must not bring back what nobody typed. What the pilot wrote is no surprise and can be undone.
      const history = mapStates(this.history.value, (state) => followed(state, unforeseen, read));
      const now = ontoReading(content, before, read);
      if (isJust(now, read)) this.#heldOf.value = ownerOf(now);
      else if (differences(before, read).length > 0) this.#heldOf.value = UNOWNED;
      this.show(now, history);
    });
    return moved;
  }

  override saved(owner: Owner): void {
    const now = this.content.value;
    const baseline = this.#baseline.value;
    batch(() => {
      if (now && baseline && isJust(now, baseline)) this.#heldOf.value = owner;
      super.saved(owner);
    });
  }

  /** Values that have all come back to those of the timer belong to what they were read as, and to nothing else. */
  protected override owned(content: Content, edit: Edit): Content {
    const baseline = this.#baseline.value;
    const isSaid = 'owner' in edit && edit.owner !== undefined;
    return isSaid || !baseline || !isJust(content, baseline) ? content : { ...content, ...this.#heldOf.value };
  }

  /** A write was read back, which settles all conflicts. */
  wrote(held: TimerProgram): void {
    batch(() => {
      this.rebase(held);
      this.#moved.value = NO_CONFLICTS;
    });
  }

  /** A command was sent that may store: the timer may hold something else than what was read. */
  sent(): void {
    this.#fresh.value = false;
  }

  /** Sets the fields that a write has confirmed, or none; see {@link confirmed}. */
  confirm(fields: readonly ProgramField[]): void {
    this.#confirmed.value = new Set(fields.map(fieldKey));
  }

  /** The timer has acknowledged a value, so the timer now holds it, whatever the pilot wants by now. */
  acknowledge(field: ProgramField, value: number): void {
    const baseline = this.#baseline.value;
    if (baseline) this.#baseline.value = withValues(baseline, [{ field, value }]);
  }

  /** Everything that is needed to come back to this point. */
  snapshot(): EditorContent | null {
    const made = this.#made.value;
    const baseline = made?.from ?? this.#baseline.value;
    const content = this.content.value;
    const kept = baseline && content && { baseline, ...content, history: this.history.value };
    return kept && made ? { ...kept, madeAt: made.at } : kept;
  }

  /**
   * Comes back to a snapshot. Drops texts of fields that do not exist, and a history that does not fit.
   * @returns false, with nothing changed, when the two programs do not have the same layout.
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
   * Shows a new program that is from no timer.
   * @param from the setting that it is opened from, or the model whose backup it is.
   */
  make(program: TimerProgram, from: Owner = {}): void {
    const at = Math.max(Date.now(), this.#lastMade + 1);
    this.#lastMade = at;
    this.#begin(null, false, { working: program, texts: {}, ...from }, EMPTY_HISTORY, { at, from: program });
  }

  /** Shows no program. */
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
      this.#heldOf.value = baseline && content && isJust(content, baseline) ? ownerOf(content) : UNOWNED;
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
