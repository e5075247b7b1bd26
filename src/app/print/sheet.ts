import { checkProgram, type Model, type ProgramField, type TimerProgram } from '../../program/index.js';
import { formatTime } from '../editing/units.js';
import { fieldLabel, fieldName, findingText, messages, secondsText } from '../messages/index.js';
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
  /** The mark of a value that is not as this says: “was 3:00”. Empty for others. Default: no marks. */
  readonly was?: (field: ProgramField) => string;
  readonly simulated: boolean;
  /** Everything but the note as a link, for a QR code. Null when no code is wanted, or none is possible. */
  readonly link: string | null;
}

/** One program as it is printed, in words. */
export interface Sheet extends Required<Omit<SheetSource, 'model' | 'note'>> {
  /** Empty when the model is not known: there is room to write its name. */
  readonly model: string;
  /** “F1Q, firmware 536, 10 functions, 3 servos”. */
  readonly timer: string;
  /** “M1 “calm””; empty when it is not known. */
  readonly memory: string;
  readonly figures: readonly (KeyFigure & { readonly isShort: boolean; readonly was: string })[];
  /** Values beside the table: the idle throttle, if the timer has told it, and times without a meaning. */
  readonly others: readonly { readonly label: string; readonly text: string }[];
  /** What each servo moves, as the pilot says; empty texts otherwise. */
  readonly servos: readonly string[];
  /** What may cost a model, in sentences. */
  readonly warnings: readonly string[];
  /** The paragraphs of the note. */
  readonly note: readonly string[];
}

/** @param shortDt a DT below this counts as short, in hundredths of a second. */
export function sheetOf(source: SheetSource, shortDt?: number): Sheet {
  const { program, model, was = () => '' } = source;
  const { identity, memory } = program;
  const findings = checkProgram(program, { shortDt });
  const isShort = findings.some(({ code }) => code === 'dt-short');
  const { about } = messages.value;
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

function othersOf(program: TimerProgram, was: Sheet['was']): Sheet['others'] {
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
