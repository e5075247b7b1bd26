import { computed, type ReadonlySignal } from '@preact/signals';
import { fieldKey, type ProgramField, type TimerProgram } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import { isOfOneShape } from '../editing/shape.js';
import type { Backup, SettingRecord } from '../storage/index.js';
import type { Held } from '../timer/standing.js';
import type { Session } from '../work/session.js';
import { backupKey, type ComparedPair, memoryKey, SCREEN, settingKey, versionKey } from './choice.js';

/** A program that can be compared: on the screen, with all changes; as last read from the connected timer; kept. */
export type Side = { readonly key: string; readonly program: TimerProgram } & (
  | { readonly kind: 'screen' }
  | { readonly kind: 'timer'; readonly held: Held & { readonly memory: number } }
  | { readonly kind: 'setting'; readonly record: SettingRecord }
  | { readonly kind: 'version'; readonly record: SettingRecord; readonly until: number }
  | { readonly kind: 'backup'; readonly backup: Backup }
);

type CompareParts = Pick<Session, 'editor' | 'standings' | 'library' | 'backups' | 'connection'>;

/** Compares any two programs: on the screen, in the timer, settings, backups. */
export class Compare {
  /** Everything that can be compared, in the order of the list. */
  readonly sides: ReadonlySignal<readonly Side[]> = computed(() =>
    sidesOf(this.#parts, [this.#pair.first.value, this.#pair.second.value]),
  );
  /** A program that is gone gives way to one that is there; null when there is nothing at all. */
  readonly first = computed(() => chosen(this.sides.value, this.#pair.first.value));
  /** What the first program can be compared with: programs of its class and layout. */
  readonly others = computed(() => {
    const first = this.first.value;
    const fits = (side: Side): boolean =>
      first !== null && side.key !== first.key && isOfOneShape(side.program.identity, first.program.identity);
    return this.sides.value.filter(fits);
  });
  /** Null when there is nothing to compare with. */
  readonly second = computed(() => chosen(this.others.value, this.#pair.second.value));
  readonly #parts: CompareParts;
  readonly #pair: ComparedPair;

  constructor(parts: CompareParts, pair: ComparedPair) {
    this.#parts = parts;
    this.#pair = pair;
  }

  /** Takes one value of the other program into the program on the screen, as a step of its own. */
  take(field: ProgramField, value: number): void {
    const name = { code: 'change', params: { field: fieldKey(field) } } as const;
    this.#parts.editor.apply(setValues(name, [{ field, value }]));
  }
}

/** @param chosen the keys of both sides: only settings that stand there show their earlier versions. */
function sidesOf(
  { editor, standings, library, backups, connection }: CompareParts,
  chosen: readonly (string | null)[],
): Side[] {
  const working = editor.working.value;
  const read = connection.value ? standings.readMemories().filter(({ known }) => known.state === 'read') : [];
  const settings = library.settings.list.value;
  const shown = settings.filter(({ key }) => chosen.some((each) => each?.split('/')[1] === key));
  return [
    ...(working ? [{ kind: 'screen', key: SCREEN, program: working } as const] : []),
    ...read.map((held): Side => ({ kind: 'timer', key: memoryKey(held.memory), held, program: held.program })),
    ...settings.map((record): Side => {
      return { kind: 'setting', key: settingKey(record.key), record, program: record.setting.program };
    }),
    ...shown.flatMap((record) =>
      (record.versions ?? []).map(({ program, until }): Side => {
        return { kind: 'version', key: versionKey(record.key, until), record, until, program };
      }),
    ),
    ...backups.list.value.map((backup): Side => {
      return { kind: 'backup', key: backupKey(backup.key), backup, program: backup.program };
    }),
  ];
}

function chosen(sides: readonly Side[], key: string | null): Side | null {
  return sides.find((side) => side.key === key) ?? sides[0] ?? null;
}
