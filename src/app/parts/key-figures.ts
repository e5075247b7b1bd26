import { columnKind, type ProgramField } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { messages } from '../messages/index.js';

/** What a pilot looks at first: DT, and on class Q the motor stop. */
export function keyFields({ timerClass, functions }: Identity): ProgramField[] {
  const dt: ProgramField = { kind: 'time', column: functions };
  return timerClass === 'Q' ? [dt, { kind: 'time', column: 0 }] : [dt];
}

/** What such a field is called in a sentence: “DT”, “motor stop”; null for any other. */
export function keyName(identity: Identity, field: ProgramField): string | null {
  const { knowledge: words } = messages.value;
  if (field.kind !== 'time') return null;
  const kind = columnKind(identity, field.column);
  if (kind === 'dt') return words.dt;
  return kind === 'start' && identity.timerClass === 'Q' ? words.motorStop : null;
}
