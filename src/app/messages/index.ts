import { signal } from '@preact/signals';
import { columnKind, type Finding, type ProgramField } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { KnownPort } from '../../serial/index.js';
import { formatTime } from '../units.js';
import { en } from './en.js';

export type { Said, TimelineFacts } from './en.js';

/** What every language must give: a missing sentence does not compile. */
export type Messages = typeof en;

/** The language in force. Components read it, so that all of them follow when it changes. */
export const messages = signal<Messages>(en);

export function columnLabel(identity: Identity, column: number): string {
  return messages.value.columnName(column, columnKind(identity, column));
}

/** What a field is called: “DT time”, “Motor stop time”, “Function 3, S1”. */
export function fieldLabel(identity: Identity, field: ProgramField): string {
  const { program, servoName } = messages.value;
  if (field.kind === 'idleThrottle') return program.idleThrottle;
  const column = columnLabel(identity, field.column);
  if (field.kind === 'position') return program.positionOf(column, servoName(field.servo));
  return field.column === 0 && identity.timerClass === 'Q' ? program.motorStopTime : program.timeOf(column);
}

/** The sentence for a finding of the check, with times as a pilot writes them. */
export function findingText({ code, params, field }: Finding): string {
  const isTime = field?.kind === 'time';
  const { findings, seconds } = messages.value;
  const shown = Object.entries(params).map(([name, value]): [string, string] => [
    name,
    isTime && typeof value === 'number' ? seconds(formatTime(value)) : String(value),
  ]);
  return findings[code](Object.fromEntries(shown));
}

export function timerName({ timerClass }: Identity): string {
  const { classNames, unknownClass } = messages.value;
  return classNames[timerClass] ?? unknownClass(timerClass);
}

/** “FTDI adapter”, “USB adapter 1234:5678”. */
export function portName({ kind, info }: Pick<KnownPort, 'kind' | 'info'>): string {
  const { portNames, portNumbers } = messages.value.link;
  if (kind !== 'usb') return portNames[kind];
  const hex = (value: number | undefined): string => (value ?? 0).toString(16).padStart(4, '0');
  return `${portNames.usb} ${portNumbers(hex(info.usbVendorId), hex(info.usbProductId))}`;
}

/** A day and a time of day, as they are written in this language. */
export function dateText(time: number): string {
  const { locale, dateTime } = messages.value;
  return new Date(time).toLocaleString(locale, dateTime);
}
