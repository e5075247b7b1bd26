import { type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { fieldInSentence, figureText } from './index.js';

/** A figure that a pilot looks at first. */
export interface KeyFigure {
  readonly field: ProgramField;
  /** “DT”, “motor stop”. */
  readonly label: string;
  /** With its unit: “3:00 min”. */
  readonly text: string;
}

/** The fields that a pilot looks at first: DT, and on class Q the motor stop. */
export function keyFields({ timerClass, functions }: Identity): ProgramField[] {
  const dt: ProgramField = { kind: 'time', slot: functions };
  return timerClass === 'Q' ? [dt, { kind: 'time', slot: 0 }] : [dt];
}

/** The key figures of a program. */
export function keyFigures(program: TimerProgram): readonly KeyFigure[] {
  const { identity } = program;
  return keyFields(identity).map((field) => ({
    field,
    label: fieldInSentence(identity, field),
    text: figureText(identity, field, valueAt(program, field) ?? 0),
  }));
}
