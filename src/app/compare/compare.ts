import { computed, type ReadonlySignal } from '@preact/signals';
import { fieldKey, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import { isOfOneShape } from '../editing/shape.js';
import type { Session } from '../session/session.js';
import type { Backup, SettingRecord } from '../storage/index.js';
import { backupKey, type ComparedPair, SCREEN, settingKey } from './choice.js';

/** A program that is at hand. */
export type Side =
  /** What is on the screen, with all changes. */
  | { readonly kind: 'screen'; readonly key: 'screen'; readonly program: TimerProgram }
  /** What was last read of a memory of the timer that is connected. */
  | { readonly kind: 'timer'; readonly key: string; readonly memory: number; readonly program: TimerProgram }
  | { readonly kind: 'setting'; readonly key: string; readonly record: SettingRecord; readonly program: TimerProgram }
  | { readonly kind: 'backup'; readonly key: string; readonly backup: Backup; readonly program: TimerProgram };

/** Any two of the programs that are at hand side by side: on the screen, in the timer, settings, backups. */
export class Compare {
  /** All that can be compared, in the order in which they are offered. */
  readonly sides: ReadonlySignal<readonly Side[]>;
  /** Null where there is nothing at all. */
  readonly first: ReadonlySignal<Side | null>;
  /** What the first can be compared with: of its class and layout. */
  readonly others: ReadonlySignal<readonly Side[]>;
  /** Null where there is nothing to compare with. */
  readonly second: ReadonlySignal<Side | null>;
  readonly #session: Session;
  readonly #pair: ComparedPair;

  constructor(session: Session, pair: ComparedPair) {
    this.#session = session;
    this.#pair = pair;
    this.sides = computed(() => sidesOf(session));
    // What is gone gives way to what is there.
    this.first = computed(() => chosen(this.sides.value, this.#pair.first.value));
    this.others = computed(() => {
      const first = this.first.value;
      return first
        ? this.sides.value.filter(
            (side) => side.key !== first.key && isOfOneShape(side.program.identity, first.program.identity),
          )
        : [];
    });
    this.second = computed(() => chosen(this.others.value, this.#pair.second.value));
  }

  chooseFirst(key: string): void {
    // What was first becomes the other one where it is chosen there.
    this.#pair.show(key, key === this.second.peek()?.key ? (this.first.peek()?.key ?? null) : this.#pair.second.peek());
  }

  chooseSecond(key: string): void {
    this.#pair.show(this.first.peek()?.key ?? null, key);
  }

  swap(): void {
    this.#pair.show(this.second.peek()?.key ?? null, this.first.peek()?.key ?? null);
  }

  /** A value of the other one goes into the program on the screen, as a step of its own. */
  take(field: ProgramField): void {
    const from = [this.first.peek(), this.second.peek()].find((side) => side && side.key !== SCREEN);
    const value = from && valueAt(from.program, field);
    if (value === null || value === undefined) return;
    const name = { code: 'take-across', params: { field: fieldKey(field) } } as const;
    this.#session.editor.apply(setValues(name, [{ field, value }]));
  }

  /** Opens the setting that is compared, so that values can be taken into it. */
  async open({ record: { setting }, key }: Extract<Side, { kind: 'setting' }>): Promise<void> {
    const other = [this.first.peek(), this.second.peek()].find((side) => side && side.key !== key);
    if (await this.#session.opened.show(setting)) this.#pair.show(SCREEN, other?.key ?? null);
  }
}

function sidesOf({ editor, knowledge, library, backups, connection }: Session): Side[] {
  const working = editor.working.value;
  const memories = connection.value?.identity.memories ?? 0;
  const read = Array.from({ length: memories }, (_, memory): Side | null => {
    const known = knowledge.of(memory);
    return known.state === 'read' ? { kind: 'timer', key: `timer/${memory}`, memory, program: known.program } : null;
  });
  return [
    ...(working ? [{ kind: SCREEN, key: SCREEN, program: working } as const] : []),
    ...read.filter((side) => side !== null),
    ...library.settings.list.value.map(
      (record): Side => ({
        kind: 'setting',
        key: settingKey(record.key),
        record,
        program: record.setting.program,
      }),
    ),
    ...backups.list.value.map(
      (backup): Side => ({ kind: 'backup', key: backupKey(backup.key), backup, program: backup.program }),
    ),
  ];
}

function chosen(sides: readonly Side[], key: string | null): Side | null {
  return sides.find((side) => side.key === key) ?? sides[0] ?? null;
}
