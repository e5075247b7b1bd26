import type { TextCell } from './clipboard-table.js';
import { FIRST_SERVO_COLUMN, INTERVAL_COLUMN, TIME_COLUMN } from './grid.js';
import { bareName, type ColumnPlace, type RowPlace } from './paste-names.js';

/** What a pilot says about a name that is not known. Slots and servos count from 0. */
export type PasteAnswer =
  | 'none'
  | 'names'
  | 'motor'
  | 'time'
  | 'minutes'
  | 'interval'
  | `slot:${number}`
  | `servo:${number}`;

/** The answers by the keys of the questions. */
export type PasteAnswers = ReadonlyMap<string, PasteAnswer>;

/** The name of a row or column that is not known. */
export interface PasteQuestion extends TextCell {
  readonly key: string;
  readonly of: 'row' | 'column';
  /** Null until the pilot has said it. */
  readonly answer: PasteAnswer | null;
}

/** “funktion 3”. */
const NUMBERED = /^(.*?) ?(\d{1,3})$/;

/**
 * The questions about one text. Names that differ only in their number are asked about once: when “Funktion 1” is
 * function 1, “Funktion 2” is function 2.
 */
export class PasteQuestions {
  readonly #asked = new Map<string, PasteQuestion>();

  readonly functions: number;
  readonly answers: PasteAnswers;

  constructor(functions: number, answers: PasteAnswers) {
    this.functions = functions;
    this.answers = answers;
  }

  /** In the order of the text. */
  get list(): PasteQuestion[] {
    return [...this.#asked.values()];
  }

  answered(of: PasteQuestion['of'], asked: TextCell): PasteAnswer | null {
    return this.answers.get(keyOf(of, asked)) ?? null;
  }

  row(asked: TextCell): RowPlace {
    const answer = this.#ask('row', asked);
    if (answer === 'motor' || answer === 'none') return answer;
    const slot = numberIn(answer, 'slot');
    return slot === null ? 'unknown' : { slot };
  }

  column(asked: TextCell): ColumnPlace {
    const answer = this.#ask('column', asked);
    if (answer === 'none' || answer === 'names') return answer;
    if (answer === 'interval') return { column: INTERVAL_COLUMN, inMinutes: false };
    if (answer === 'time' || answer === 'minutes') return { column: TIME_COLUMN, inMinutes: answer === 'minutes' };
    const servo = numberIn(answer, 'servo');
    return servo === null ? 'unknown' : { column: FIRST_SERVO_COLUMN + servo, inMinutes: false };
  }

  #ask(of: PasteQuestion['of'], asked: TextCell): PasteAnswer | null {
    const key = keyOf(of, asked);
    const alike = this.#alike(of, asked);
    if (alike !== undefined) return alike;
    const answer = this.answers.get(key) ?? null;
    this.#asked.set(key, { ...asked, key, of, answer });
    return answer;
  }

  /** What follows from the answer about a name with another number; undefined where nothing does. */
  #alike(of: PasteQuestion['of'], { text }: TextCell): PasteAnswer | null | undefined {
    const [, stem, number] = NUMBERED.exec(bareName(text)) ?? [];
    if (stem === undefined || stem === '') return undefined;
    for (const question of this.#asked.values()) {
      const [, otherStem, otherNumber] = NUMBERED.exec(bareName(question.text)) ?? [];
      if (question.of !== of || otherStem !== stem) continue;
      const { answer } = question;
      if (answer === null || answer === 'none') return answer;
      const kind = of === 'row' ? 'slot' : 'servo';
      const place = numberIn(answer, kind);
      if (place === null) continue;
      const here = place + Number(number) - Number(otherNumber);
      // Counting on never leads to DT, and there is nothing before the first.
      const isOut = here < 0 || (kind === 'slot' && here >= this.functions);
      return `${kind}:${isOut ? Number.POSITIVE_INFINITY : here}`;
    }
    return undefined;
  }
}

function keyOf(of: PasteQuestion['of'], { text, row, column }: TextCell): string {
  return `${of} ${bareName(text) || `${row} ${column}`}`;
}

function numberIn(answer: PasteAnswer | null, kind: 'slot' | 'servo'): number | null {
  const [said, number] = answer?.split(':') ?? [];
  return said === kind ? Number(number) : null;
}
