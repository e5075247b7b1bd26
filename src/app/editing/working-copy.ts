import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { fieldKey, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { computedList } from './computed-list.js';
import {
  applied,
  type Content,
  formatValue,
  inTheWay,
  meansSame,
  ownerOf,
  type UnreadableField,
  unreadableIn,
  valueOfText,
  without,
} from './content.js';
import { type Edit, type Obstacle, type Owner, type SettingOf, setValues } from './edit.js';
import * as histories from './history.js';
import { EMPTY_HISTORY, groupOf, type History, type StepName, type Turned } from './history.js';
import type { Ambiguous } from './units.js';

/**
 * What the pilot wants, with its undo history.
 * A text that is not a value stays as it was typed, beside the last value of its field.
 */
export class WorkingCopy {
  readonly #content = signal<Content | null>(null, { name: 'content' });
  readonly #history = signal<History<Content>>(EMPTY_HISTORY, { name: 'history' });
  /** The field in which somebody is typing. */
  readonly #typing = signal<string | null>(null, { name: 'typing' });

  readonly working: ReadonlySignal<TimerProgram | null> = computed(() => this.#content.value?.working ?? null);
  /** The kind of timer that it is for; null when there is no program. */
  readonly identity: ReadonlySignal<Identity | null> = computed(() => this.working.value?.identity ?? null);
  /** The setting of the library that it belongs to; undefined for none. */
  readonly of: ReadonlySignal<SettingOf | undefined> = computed(() => this.#content.value?.of);
  /** The id of the model whose backup it is, if it is one: see `Content`. */
  readonly backupOf: ReadonlySignal<string | undefined> = computed(() => this.#content.value?.backupOf);
  /** Its present content, typed texts included. */
  protected readonly content: ReadonlySignal<Content | null> = this.#content;
  protected readonly history: ReadonlySignal<History<Content>> = this.#history;

  readonly #unreadable: ReadonlySignal<readonly UnreadableField[]> = computedList(() => {
    const content = this.content.value;
    return content ? [...unreadableIn(content).values()] : [];
  }, isSameText);
  /** Fields whose text is not a value. */
  readonly unreadable: ReadonlySignal<ReadonlyMap<string, UnreadableField>> = computed(
    () => new Map(this.#unreadable.value.map((each) => [fieldKey(each.field), each])),
  );
  /**
   * The possible meanings of each ambiguous text, which the pilot is asked about.
   * A text that is still being typed does not count.
   */
  readonly asked: ReadonlySignal<ReadonlyMap<string, Ambiguous['either']>> = computed(() => {
    const typing = this.#typing.value;
    const open = [...this.unreadable.value].flatMap(([key, { either }]) =>
      either && key !== typing ? [[key, either] as const] : [],
    );
    return new Map(open);
  });

  /** The next steps to undo and to redo; null when there is none. */
  readonly undoStep: ReadonlySignal<StepName | null> = computed(() => this.#history.value.past.at(-1)?.name ?? null);
  readonly redoStep: ReadonlySignal<StepName | null> = computed(() => this.#history.value.future.at(-1)?.name ?? null);

  /** What stands in a field: the text as typed, else its value. */
  textOf(field: ProgramField): string {
    const { value: content } = this.#content;
    if (!content) return '';
    const { working, texts } = content;
    const value = valueAt(working, field);
    return texts[fieldKey(field)] ?? (value === null ? '' : formatValue(working.identity, field, value));
  }

  /** Whether a field holds a typed text, which may be unfinished. */
  isTyped(field: ProgramField): boolean {
    return this.#content.value?.texts[fieldKey(field)] !== undefined;
  }

  /**
   * Does an edit as one step with its name. Edits of one group in a row become one step, until {@link settle}.
   * @returns why it was not done; null when it was.
   */
  apply(edit: Edit): Obstacle | null {
    const before = this.content.value;
    if (!before) return null;
    if ('refused' in edit) return edit.refused;
    const field = inTheWay(this.unreadable.value, edit);
    if (field) return { code: 'unreadable', field };
    const { open, past } = this.#history.value;
    const last = past.at(-1);
    // On the way to its end a step may pass the values of another owner: what counts is where it began.
    const began = last && edit.group !== undefined && edit.group === open ? last.state : before;
    const after = this.owned(applied({ ...before, ...ownerOf(began) }, edit), edit);
    // An edit that changes nothing is no step.
    if (after.working === before.working && after.texts === before.texts && after.of === before.of) return null;
    this.show(after, histories.recordStep(this.#history.value, edit.name, before, edit.group));
    return null;
  }

  /**
   * A key was pressed in a field: keeps the text, and takes over its value if it has one. All typing is one step until
   * the field is left.
   */
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
   * The field was left, or Enter was pressed: a text with a value gets the usual form of that value. An ambiguous text
   * is asked about: see {@link asked}.
   */
  leave(field: ProgramField): void {
    const key = fieldKey(field);
    batch(() => {
      if (this.#typing.value === key) this.#typing.value = null;
      const { value: content } = this.#content;
      if (content?.texts[key] !== undefined && !this.unreadable.value.has(key)) {
        this.#content.value = { ...content, texts: without(content.texts, [key]) };
      }
      this.settle();
    });
  }

  /** The pilot has said what the text in a field means: this value. It belongs to the same step. */
  answer(field: ProgramField, value: number): void {
    batch(() => {
      if (this.endsWithTyping(field)) {
        this.#history.value = { ...this.#history.value, open: groupOf('type', fieldKey(field)) };
      }
      this.apply(typing(field, value));
      this.settle();
    });
  }

  /** Whether the last edit was typing in this field: any other change of it takes its text away. */
  protected endsWithTyping(field: ProgramField): boolean {
    const { field: key } = this.undoStep.value?.params ?? {};
    return key === fieldKey(field) && this.isTyped(field);
  }

  /**
   * Ends the last step: the field was left, or the drag has ended. A step that came back to where it began is removed.
   */
  settle(): void {
    const now = this.content.value;
    this.#history.value = histories.settle(this.#history.value, (state) => now !== null && meansSame(state, now));
  }

  undo(): void {
    this.#turn(histories.undo);
  }

  redo(): void {
    this.#turn(histories.redo);
  }

  /**
   * Takes back the step that is still growing, if it is of this group.
   * @returns whether it was.
   */
  abandon(group: string | undefined): boolean {
    return group !== undefined && this.#history.value.open === group && this.#turn(histories.abandon);
  }

  /** @returns whether there was a state to go to. */
  #turn(turn: (history: History<Content>, now: Content) => Turned<Content> | null): boolean {
    const now = this.#content.value;
    const turned = now && turn(this.#history.value, now);
    if (turned) this.show(turned.state, turned.history);
    return turned !== null;
  }

  /**
   * The content of the screen was saved as a setting, or that was undone. States of that setting in the undo history
   * are told, too.
   */
  saved(owner: Owner): void {
    const now = this.content.value;
    if (!now) return;
    const { of } = owner;
    const history = histories.mapStates(this.#history.value, (state) =>
      of && state.of?.id === of.id ? { ...state, of } : state,
    );
    // The pilot has said whose it is, in the middle of a step, too.
    this.show({ ...now, ...owner }, { ...history, open: null });
  }

  /** Whose the values are after an edit. */
  protected owned(content: Content, _edit: Edit): Content {
    return content;
  }

  /** Replaces the whole content; null for none. */
  protected show(content: Content | null, history: History<Content>): void {
    batch(() => {
      this.#content.value = content;
      this.#history.value = history;
    });
  }
}

/** Typing in a field, with the value of the text if it has one. */
function typing(field: ProgramField, value: number | null): Edit {
  const key = fieldKey(field);
  const values = value === null ? [] : [{ field, value }];
  return setValues({ code: 'change', params: { field: key } }, values, groupOf('type', key));
}

function isSameText(a: UnreadableField, b: UnreadableField): boolean {
  const isSameQuestion = a.either?.[0] === b.either?.[0] && a.either?.[1] === b.either?.[1];
  return fieldKey(a.field) === fieldKey(b.field) && a.reason === b.reason && isSameQuestion;
}
