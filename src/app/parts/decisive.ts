import { type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { figureText, messages } from '../messages/index.js';

/** A value that decides over the model: DT, and on Q the motor stop. */
export interface Decisive {
  readonly label: string;
  readonly field: ProgramField;
  /** With its unit: “3:00 min”. */
  readonly text: string;
}

/** What decides over the model in a program. */
export function decisive(program: TimerProgram): readonly Decisive[] {
  return fieldsOf(program.identity).map(({ label, field }) => ({
    label,
    field,
    text: figureText(program.identity, field, valueAt(program, field) ?? 0),
  }));
}

function fieldsOf({ timerClass, functions }: Identity): Omit<Decisive, 'text'>[] {
  const { program } = messages.value;
  const dt = { label: program.dt, field: { kind: 'time', column: functions } } as const;
  const motorStop = { label: program.motorStop, field: { kind: 'time', column: 0 } } as const;
  return timerClass === 'Q' ? [dt, motorStop] : [dt];
}
