import {
  type Change,
  checkProgram,
  fieldKey,
  type Model,
  type ProgramField,
  type TimerProgram,
} from '../../program/index.js';
import { formatTime } from '../editing/units.js';
import { fieldLabel, fieldName, findingText, messages, secondsText, valueText } from '../messages/index.js';
import { type KeyFigure, keyFigures } from '../messages/key-figures.js';
import { dutyName, timerText } from '../messages/names.js';
import { memoryOf } from '../work/memory-names.js';

/** The source of a sheet. */
export interface SheetSource {
  /** Unique among the sheets of one print. */
  readonly key: string;
  readonly program: TimerProgram;
  readonly model: Pick<Model, 'name' | 'servos' | 'memoryNames'> | null;
  /** The name of the saved program; empty without one. */
  readonly name: string;
  readonly note: string;
  /** Where the values come from, and when: “Kept 12 Nov 2026, 14:32”. */
  readonly origin: string;
  /** The values that are not as this says, and the text of a mark with the old one: “was 3:00”. Default: none. */
  readonly marks?: Marks;
  readonly simulated: boolean;
  /** Everything but the note as a link, for a QR code. Null when no code is wanted, or none is possible. */
  readonly link: string | null;
}

export interface Marks {
  readonly changes: readonly Change[];
  readonly text: (old: string) => string;
}

/** One program as it is printed, in words. */
export interface Sheet extends Pick<SheetSource, 'key' | 'program' | 'name' | 'origin' | 'simulated' | 'link'> {
  /** Empty when the model is not known: there is room to write its name. */
  readonly model: string;
  /** “F1Q, firmware 536, 10 functions, 3 servos”. */
  readonly timer: string;
  /** “M1 “calm””; empty when it is not known. */
  readonly memory: string;
  readonly figures: readonly (KeyFigure & { readonly isShort: boolean; readonly was: string })[];
  /** Values beside the table: the idle throttle, if the timer has told it, and times without a meaning. */
  readonly others: readonly { readonly label: string; readonly text: string }[];
  /** The mark of a value that has changed: what it was. Empty for others. */
  readonly was: (field: ProgramField) => string;
  /** What each servo moves, as the pilot says; empty texts otherwise. */
  readonly servos: readonly string[];
  /** What may cost a model, in sentences. */
  readonly warnings: readonly string[];
  /** The paragraphs of the note. */
  readonly note: readonly string[];
}

/** @param shortDt a DT below this counts as short, in hundredths of a second. */
export function sheetOf(source: SheetSource, shortDt?: number): Sheet {
  const { program, model } = source;
  const { identity, memory } = program;
  const findings = checkProgram(program, { shortDt });
  const isShort = findings.some(({ code }) => code === 'dt-short');
  const { about } = messages.value;
  const was = wasIn(identity, source.marks);
  return {
    ...source,
    model: model?.name ?? '',
    timer: timerText(identity),
    memory: memory === null ? '' : memoryOf(model, memory),
    figures: keyFigures(program).map((figure) => ({
      ...figure,
      isShort: isShort && figure.field.kind === 'time' && figure.field.slot === identity.functions,
      was: was(figure.field),
    })),
    others: othersOf(program, was),
    was,
    servos: program.positions.map((_, servo) => {
      const use = model?.servos[servo];
      return use ? dutyName(use) : '';
    }),
    warnings: findings
      .filter(({ severity }) => severity !== 'warning')
      .map((finding) =>
        finding.field
          ? `${about({ name: fieldName(identity, finding.field) })} ${findingText(finding)}`
          : findingText(finding),
      ),
    note: source.note.split('\n').map((line) => line.trimEnd()),
  };
}

/** Gives the mark of a field; an empty text where it has not changed. */
function wasIn(identity: TimerProgram['identity'], marks: Marks | undefined): (field: ProgramField) => string {
  const old = new Map(marks?.changes.map(({ field, from }) => [fieldKey(field), valueText(identity, field, from)]));
  return (field) => {
    const text = old.get(fieldKey(field));
    return marks && text !== undefined ? marks.text(text) : '';
  };
}

function othersOf(program: TimerProgram, was: (field: ProgramField) => string): Sheet['others'] {
  const { program: words } = messages.value;
  const { identity, idleThrottle } = program;
  const first = program.times[0] ?? 0;
  const start = { kind: 'time', slot: 0 } as const;
  const marked = (text: string, field: ProgramField): string => [text, was(field)].filter(Boolean).join(' ');
  const idle = idleThrottle !== null && marked(String(idleThrottle), { kind: 'idleThrottle' });
  const reserved =
    identity.timerClass !== 'Q' &&
    first !== 0 &&
    marked(words.reserved({ time: secondsText(formatTime(first)) }), start);
  return [
    ...(idle ? [{ label: words.idleThrottle, text: idle }] : []),
    ...(reserved ? [{ label: fieldLabel(identity, start), text: reserved }] : []),
  ];
}
