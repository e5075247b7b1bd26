import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import {
  type Change,
  checkProgram,
  differences,
  type Finding,
  fieldKey,
  fieldsOf,
  hasErrors,
  type ProgramField,
  sameLayout,
  type TimerProgram,
  valueAt,
  withValue,
} from '../../program/index.js';
import { formatTime, type Parsed, parseSteps, parseTime, type UnreadableReason } from '../units.js';

/** A text in a field, as it was typed. */
interface Typed {
  readonly field: ProgramField;
  readonly text: string;
}

/** What can be put back into an editor: see {@link Editor.snapshot}. */
export interface EditorContent {
  readonly baseline: TimerProgram;
  readonly working: TimerProgram;
  readonly texts: Readonly<Record<string, string>>;
}

/**
 * The program on the screen. The baseline is what the timer last said, the working copy what the pilot wants; everything else
 * follows from the two. A text that is no value is kept as it was typed, beside the last value that was one.
 */
export class Editor {
  readonly baseline = signal<TimerProgram | null>(null, { name: 'baseline' });
  readonly working = signal<TimerProgram | null>(null, { name: 'working' });
  readonly #typed = signal<ReadonlyMap<string, Typed>>(new Map(), { name: 'typed' });
  /** What the timer held where it has changed under the pilot's edits, by field: `from` when they were made, `to` by the last read. */
  readonly conflicts = signal<ReadonlyMap<string, Change>>(new Map(), { name: 'conflicts' });

  /** What differs from the timer. */
  readonly changes: ReadonlySignal<readonly Change[]> = computed(() => {
    const from = this.baseline.value;
    const to = this.working.value;
    return from && to ? differences(from, to) : [];
  });
  readonly changed: ReadonlySignal<ReadonlyMap<string, Change>> = computed(
    () => new Map(this.changes.value.map((change) => [fieldKey(change.field), change])),
  );
  /** Fields whose text is no value. */
  readonly unreadable: ReadonlySignal<ReadonlyMap<string, { field: ProgramField; reason: UnreadableReason }>> =
    computed(() => {
      const found = new Map<string, { field: ProgramField; reason: UnreadableReason }>();
      for (const [key, { field, text }] of this.#typed.value) {
        const parsed = parse(field, text);
        if ('unreadable' in parsed) found.set(key, { field, reason: parsed.unreadable });
      }
      return found;
    });
  readonly findings: ReadonlySignal<readonly Finding[]> = computed(() => {
    const working = this.working.value;
    return working ? checkProgram(working, { baseline: this.baseline.value ?? undefined }) : [];
  });
  /** Whether something stands in the way of a write. */
  readonly blocked: ReadonlySignal<boolean> = computed(
    () => this.unreadable.value.size > 0 || hasErrors(this.findings.value),
  );
  /** Whether there is anything that a reload would lose. */
  readonly dirty: ReadonlySignal<boolean> = computed(
    () => this.changes.value.length > 0 || this.unreadable.value.size > 0,
  );

  /** What stands in a field: the text as typed, else its value. */
  textOf(field: ProgramField): string {
    const typed = this.#typed.value.get(fieldKey(field));
    if (typed) return typed.text;
    const value = this.working.value && valueAt(this.working.value, field);
    return value === null ? '' : formatValue(field, value);
  }

  /** A key was pressed in a field: the text is kept, and its value taken over if it has one. */
  type(field: ProgramField, text: string): void {
    const parsed = parse(field, text);
    batch(() => {
      this.#typed.value = new Map(this.#typed.value).set(fieldKey(field), { field, text });
      if ('value' in parsed && this.working.value) {
        this.working.value = withValue(this.working.value, field, parsed.value);
      }
    });
  }

  /** The field was left: a text that has a value gives way to that value's usual form. */
  leave(field: ProgramField): void {
    const key = fieldKey(field);
    if (this.unreadable.value.has(key)) return;
    this.#forget([key]);
  }

  /** Puts one field back to what the timer holds. */
  revert(field: ProgramField): void {
    const { baseline, working } = this;
    const held = baseline.value && valueAt(baseline.value, field);
    batch(() => {
      this.#forget([fieldKey(field)]);
      if (held !== null && working.value) working.value = withValue(working.value, field, held);
    });
  }

  /** Puts everything back to what the timer holds. */
  revertAll(): void {
    if (this.baseline.value) this.replace(this.baseline.value);
    this.conflicts.value = new Map();
  }

  /** Puts a whole program of the same layout in the place of what the pilot wants. */
  replace(program: TimerProgram): void {
    batch(() => {
      this.#typed.value = new Map();
      this.working.value = program;
    });
  }

  /**
   * The timer was read. Edits stay: they are taken over onto what the timer holds now.
   * @returns whether there are edits and the timer holds something else than when they were made, beyond what the pilot wants anyway:
   * a part of the edits may have been written.
   */
  rebase(read: TimerProgram): boolean {
    const before = this.baseline.value;
    const edits = before && sameLayout(before.identity, read.identity) ? this.changes.value : [];
    const wanted = this.working.value;
    const moved =
      edits.length > 0 &&
      before !== null &&
      wanted !== null &&
      differences(before, read).some(({ field, to }) => valueAt(wanted, field) !== to);
    batch(() => {
      this.#noteConflicts(moved && before ? differences(before, read) : []);
      this.baseline.value = read;
      this.working.value = edits.reduce(
        (program, { field, to }) => (to === null ? program : withValue(program, field, to)),
        read,
      );
      if (!before || !sameLayout(before.identity, read.identity)) this.#typed.value = new Map();
      // A text that says what the timer held before must not stand for what it holds now.
      const stays = new Set([...this.unreadable.value.keys(), ...this.changed.value.keys()]);
      this.#forget([...this.#typed.value.keys()].filter((key) => !stays.has(key)));
    });
    return moved;
  }

  /** A write was read back: whatever was in conflict is decided. */
  wrote(held: TimerProgram): void {
    batch(() => {
      this.rebase(held);
      this.conflicts.value = new Map();
    });
  }

  /** What has to be kept to come back to this point. */
  snapshot(): EditorContent | null {
    const { baseline, working } = this;
    if (!baseline.value || !working.value) return null;
    const texts = Object.fromEntries([...this.#typed.value].map(([key, { text }]) => [key, text]));
    return { baseline: baseline.value, working: working.value, texts };
  }

  /**
   * Comes back to what was kept. Texts of fields that do not exist are dropped.
   * @returns false, and nothing is changed, when the two programs do not fit together.
   */
  restore({ baseline, working, texts }: EditorContent): boolean {
    if (!sameLayout(baseline.identity, working.identity)) return false;
    batch(() => {
      this.baseline.value = baseline;
      this.working.value = working;
      const typed = fieldsOf(working.identity).flatMap((field): [string, Typed][] => {
        const text = texts[fieldKey(field)];
        return text === undefined ? [] : [[fieldKey(field), { field, text }]];
      });
      this.#typed.value = new Map(typed);
      this.conflicts.value = new Map();
    });
    return true;
  }

  /** Nothing on the screen. */
  clear(): void {
    batch(() => {
      this.baseline.value = null;
      this.working.value = null;
      this.#typed.value = new Map();
      this.conflicts.value = new Map();
    });
  }

  /** Several readings one after the other: what counts is what was held when the edits were made. */
  #noteConflicts(changes: readonly Change[]): void {
    if (changes.length === 0) return;
    const noted = new Map(this.conflicts.value);
    for (const change of changes) {
      const key = fieldKey(change.field);
      noted.set(key, { ...change, from: noted.get(key)?.from ?? change.from });
    }
    this.conflicts.value = new Map([...noted].filter(([, { from, to }]) => from !== to));
  }

  #forget(keys: readonly string[]): void {
    if (!keys.some((key) => this.#typed.value.has(key))) return;
    const typed = new Map(this.#typed.value);
    for (const key of keys) typed.delete(key);
    this.#typed.value = typed;
  }
}

function parse(field: ProgramField, text: string): Parsed {
  return field.kind === 'time' ? parseTime(text) : parseSteps(text);
}

/** A value in the form in which a pilot reads and types it. */
export function formatValue(field: ProgramField, value: number): string {
  return field.kind === 'time' ? formatTime(value) : String(value);
}
