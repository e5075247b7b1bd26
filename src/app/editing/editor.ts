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
import type { Identity } from '../../protocol/index.js';
import { computedList } from './computed-list.js';
import {
  applied,
  type Content,
  conflictsWith,
  followed,
  formatValue,
  inTheWay,
  meansSame,
  ontoReading,
  textsFor,
  type UnreadableField,
  unreadableIn,
  valueOfText,
  without,
} from './content.js';
import { type Edit, type Obstacle, putBack, replaceAll, setValues, withValues } from './edit.js';
import * as histories from './history.js';
import { groupOf, type History, type StepName, type Turned } from './history.js';
import type { Question } from './units.js';

/** What can be put back into an editor: see {@link Editor.snapshot}. */
export interface EditorContent extends Content {
  readonly baseline: TimerProgram;
  readonly history?: History<Content> | undefined;
  /** When the baseline was read, in milliseconds since 1970; null where that is not known. Not the editor's own: see `Knowledge`. */
  readonly readAt?: number | null | undefined;
}

/**
 * The program on the screen. The baseline is what the timer last said, the working copy what the pilot wants; everything else
 * follows from the two. A text that is no value is kept as it was typed, beside the last value that was one.
 */
export class Editor {
  readonly baseline = signal<TimerProgram | null>(null, { name: 'baseline' });
  readonly working = signal<TimerProgram | null>(null, { name: 'working' });
  /** Whether the baseline is what a reading of this connection gave, whole, with nothing sent since. */
  readonly fresh = signal(false, { name: 'fresh' });
  readonly #texts = signal<Content['texts']>({}, { name: 'texts' });
  readonly #history = signal<History<Content>>(histories.EMPTY_HISTORY, { name: 'history' });
  /** The field in which a text is being typed. */
  readonly #typing = signal<string | null>(null, { name: 'typing' });
  readonly #moved = signal<ReadonlyMap<string, Change>>(new Map(), { name: 'moved' });

  /** What kind of timer the program on the screen is for; null when there is none. */
  readonly identity: ReadonlySignal<Identity | null> = computed(() => this.working.value?.identity ?? null);

  /** What differs from the timer. */
  readonly changes: ReadonlySignal<readonly Change[]> = computed(() => {
    const from = this.baseline.value;
    const to = this.working.value;
    return from && to ? differences(from, to) : [];
  });
  readonly changed: ReadonlySignal<ReadonlyMap<string, Change>> = computed(
    () => new Map(this.changes.value.map((change) => [fieldKey(change.field), change])),
  );
  /** What the timer held where it has changed under the pilot's edits, by field: `from` when they were made, `to` by the last read. */
  readonly conflicts: ReadonlySignal<ReadonlyMap<string, Change>> = computed(
    () => new Map([...this.#moved.value].filter(([key]) => this.changed.value.has(key))),
  );
  readonly #unreadable: ReadonlySignal<readonly UnreadableField[]> = computedList(() => {
    const content = this.#content();
    return content ? [...unreadableIn(content).values()] : [];
  }, isSameUnreadable);
  /** Fields whose text is no value. */
  readonly unreadable: ReadonlySignal<ReadonlyMap<string, UnreadableField>> = computed(
    () => new Map(this.#unreadable.value.map((each) => [fieldKey(each.field), each])),
  );
  /** What each of these texts may mean: the pilot is asked. While one is being typed it is not finished, and he is not. */
  readonly asked: ReadonlySignal<ReadonlyMap<string, Question['either']>> = computed(() => {
    const typing = this.#typing.value;
    return new Map(
      [...this.unreadable.value].flatMap(([key, { either }]): [string, Question['either']][] =>
        either && key !== typing ? [[key, either]] : [],
      ),
    );
  });
  /** A DT below this is called short, in hundredths of a second. */
  readonly shortDt = signal(6000, { name: 'shortDt' });
  readonly findings: ReadonlySignal<readonly Finding[]> = computedList(() => {
    const working = this.working.value;
    return working
      ? checkProgram(working, { baseline: this.baseline.value ?? undefined, shortDt: this.shortDt.value })
      : [];
  }, isSameFinding);
  /** Whether something stands in the way of a write. */
  readonly blocked: ReadonlySignal<boolean> = computed(
    () => this.unreadable.value.size > 0 || hasErrors(this.findings.value),
  );
  /** Whether there is anything that a reload would lose. */
  readonly dirty: ReadonlySignal<boolean> = computed(
    () => this.changes.value.length > 0 || this.unreadable.value.size > 0,
  );

  /** What would be undone, and redone, next; null when there is nothing. */
  readonly undoStep: ReadonlySignal<StepName | null> = computed(() => this.#history.value.past.at(-1)?.name ?? null);
  readonly redoStep: ReadonlySignal<StepName | null> = computed(() => this.#history.value.future.at(-1)?.name ?? null);

  /** What stands in a field: the text as typed, else its value. */
  textOf(field: ProgramField): string {
    const text = this.#texts.value[fieldKey(field)];
    if (text !== undefined) return text;
    const value = this.working.value && valueAt(this.working.value, field);
    return value === null ? '' : formatValue(field, value);
  }

  /** Whether a text that was typed stands in a field: it may not be finished. */
  isTyped(field: ProgramField): boolean {
    return this.#texts.value[fieldKey(field)] !== undefined;
  }

  /**
   * Does an edit, as one step with its name. Edits of one group that follow each other become one step, until {@link settle}.
   * @returns why it was not done; null when it was.
   */
  apply(edit: Edit): Obstacle | null {
    const before = this.#content();
    if (!before) return null;
    if ('refused' in edit) return edit.refused;
    const field = inTheWay(this.unreadable.value, edit);
    if (field) return { code: 'unreadable', field };
    const after = applied(before, edit);
    // What changes nothing is no step.
    if (after.working === before.working && after.texts === before.texts) return null;
    this.#turn({ history: histories.record(this.#history.value, edit.name, before, edit.group), state: after });
    return null;
  }

  /** A key was pressed in a field: the text is kept, and its value taken over if it has one. One step until the field is left. */
  type(field: ProgramField, text: string): void {
    const now = this.working.value;
    if (!now) return;
    const key = fieldKey(field);
    const { open, past } = this.#history.value;
    const began = open === groupOf('type', key) ? past.at(-1)?.state.working : undefined;
    const value = valueOfText(field, text, began ?? now);
    batch(() => {
      this.apply({ ...typing(field, value), texts: { [key]: text } });
      this.#typing.value = key;
    });
  }

  /**
   * The field was left, or Enter was pressed in it: a text that has a value gives way to that value's usual form. One that may mean two things
   * is asked about: see {@link asked}.
   */
  leave(field: ProgramField): void {
    const key = fieldKey(field);
    batch(() => {
      if (this.#typing.value === key) this.#typing.value = null;
      if (!this.unreadable.value.has(key)) this.#texts.value = without(this.#texts.value, [key]);
      this.settle();
    });
  }

  /** What was asked about the text in a field is answered, as part of the same step: it is this value. */
  answer(field: ProgramField, value: number): void {
    const key = fieldKey(field);
    batch(() => {
      if (this.#endsWithTyping(key)) this.#history.value = { ...this.#history.value, open: groupOf('type', key) };
      this.apply(typing(field, value));
      this.settle();
    });
  }

  /** What was asked is not answered: the text is taken back, or where more was done since then the field is put back to what the timer holds. */
  takeBack(field: ProgramField): void {
    if (this.#endsWithTyping(fieldKey(field))) this.undo();
    else this.revert(field);
  }

  /** Whether the last thing that was done is typing in this field. */
  #endsWithTyping(key: string): boolean {
    const last = this.#history.value.past.at(-1)?.name;
    if (last?.code !== 'type') return false;
    const { field } = last.params;
    return field === key;
  }

  /**
   * Escape in a field: what was typed last, or stepped last, since it was entered will not have been; if nothing was, the field is put back
   * to what the timer holds.
   */
  escape(field: ProgramField): void {
    const key = fieldKey(field);
    const taken = this.abandon(groupOf('type', key)) || this.abandon(groupOf('step', key));
    if (!taken) this.revert(field);
  }

  /**
   * Takes the step back that is still growing, if it is of this group.
   * @returns whether it was.
   */
  abandon(group: string | undefined): boolean {
    const growing =
      group !== undefined && this.#history.value.open === group ? histories.abandon(this.#history.value) : null;
    this.#turn(growing);
    return growing !== null;
  }

  /** The field was left, the drag has ended: what follows is a step of its own. What has come back to where it began was none. */
  settle(): void {
    const now = this.#content();
    this.#history.value = histories.settle(this.#history.value, (state) => now !== null && meansSame(state, now));
  }

  undo(): void {
    const now = this.#content();
    if (now) this.#turn(histories.undo(this.#history.value, now));
  }

  redo(): void {
    const now = this.#content();
    if (now) this.#turn(histories.redo(this.#history.value, now));
  }

  /** Puts one field back to what the timer holds. */
  revert(field: ProgramField): void {
    this.revertFields({ code: 'revert', params: { field: fieldKey(field) } }, [field]);
  }

  /** Puts some fields back to what the timer holds, as one step. */
  revertFields(name: StepName, fields: readonly ProgramField[]): void {
    const baseline = this.baseline.value;
    if (baseline) this.apply(putBack(name, baseline, fields));
  }

  /** Puts everything back to what the timer holds. */
  revertAll(): void {
    const baseline = this.baseline.value;
    if (baseline) this.apply(replaceAll({ code: 'revert-all', params: {} }, baseline));
    this.#moved.value = new Map();
  }

  /**
   * The timer was read. Edits stay: they are taken over onto what the timer holds now.
   * @returns whether there are edits and the timer holds something else than when they were made, beyond what the pilot wants anyway:
   * a part of the edits may have been written.
   */
  rebase(read: TimerProgram): boolean {
    const before = this.baseline.value;
    const wanted = this.working.value;
    const fits = before !== null && wanted !== null && sameLayout(before.identity, read.identity);
    if (!fits) {
      batch(() => {
        this.clear();
        this.baseline.value = read;
        this.fresh.value = true;
        this.working.value = read;
      });
      return false;
    }
    const unforeseen = differences(before, read).filter(({ field, to }) => valueAt(wanted, field) !== to);
    const moved = this.changes.value.length > 0 && unforeseen.length > 0;
    const { working, texts } = ontoReading({ working: wanted, texts: this.#texts.value }, before, read);
    batch(() => {
      if (moved) this.#moved.value = conflictsWith(this.#moved.value, differences(before, read));
      this.baseline.value = read;
      this.fresh.value = true;
      this.working.value = working;
      this.#texts.value = texts;
      // Undo must not bring back what nobody typed; what the pilot wrote is no surprise and can be undone.
      this.#history.value = histories.mapStates(this.#history.value, (state) => followed(state, unforeseen, read));
    });
    return moved;
  }

  /** A write was read back: whatever was in conflict is decided. */
  wrote(held: TimerProgram): void {
    batch(() => {
      this.rebase(held);
      this.#moved.value = new Map();
    });
  }

  /** The timer has acknowledged a value: it is what the timer holds, whatever the pilot wants by now. */
  acknowledge(field: ProgramField, value: number): void {
    const baseline = this.baseline.value;
    if (baseline) this.baseline.value = withValues(baseline, [{ field, value }]);
  }

  /** What has to be kept to come back to this point. */
  snapshot(): EditorContent | null {
    const baseline = this.baseline.value;
    const content = this.#content();
    return baseline && content && { baseline, ...content, history: this.#history.value };
  }

  /**
   * Comes back to what was kept. Texts of fields that do not exist are dropped, and a history that does not fit.
   * @returns false, and nothing is changed, when the two programs do not fit together.
   */
  restore({ baseline, working, texts, history = histories.EMPTY_HISTORY }: EditorContent): boolean {
    if (!sameLayout(baseline.identity, working.identity)) return false;
    const steps = [...history.past, ...history.future];
    const fits = steps.every(({ state }) => sameLayout(baseline.identity, state.working.identity));
    batch(() => {
      this.fresh.value = false;
      this.baseline.value = baseline;
      this.working.value = working;
      this.#texts.value = textsFor(working, texts);
      this.#history.value = fits ? histories.settle(history) : histories.EMPTY_HISTORY;
      this.#moved.value = new Map();
    });
    return true;
  }

  /** Nothing on the screen. */
  clear(): void {
    batch(() => {
      this.baseline.value = null;
      this.working.value = null;
      this.#texts.value = {};
      this.#history.value = histories.EMPTY_HISTORY;
      this.#moved.value = new Map();
    });
  }

  #content(): Content | null {
    const working = this.working.value;
    return working && { working, texts: this.#texts.value };
  }

  #turn(turned: Turned<Content> | null): void {
    if (!turned) return;
    batch(() => {
      this.#history.value = turned.history;
      this.working.value = turned.state.working;
      this.#texts.value = turned.state.texts;
    });
  }
}

/** A value that is typed in a field, or none yet. */
function typing(field: ProgramField, value: number | null): Edit {
  const key = fieldKey(field);
  const values = value === null ? [] : [{ field, value }];
  return setValues({ code: 'type', params: { field: key } }, values, groupOf('type', key));
}

function isSameUnreadable(a: UnreadableField, b: UnreadableField): boolean {
  const isSameQuestion = a.either?.[0] === b.either?.[0] && a.either?.[1] === b.either?.[1];
  return fieldKey(a.field) === fieldKey(b.field) && a.reason === b.reason && isSameQuestion;
}

function isSameFinding(a: Finding, b: Finding): boolean {
  if (a.code !== b.code || a.severity !== b.severity) return false;
  if ((a.field && fieldKey(a.field)) !== (b.field && fieldKey(b.field))) return false;
  return Object.keys({ ...a.params, ...b.params }).every((name) => a.params[name] === b.params[name]);
}
