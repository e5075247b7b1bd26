import type { ReadonlySignal } from '@preact/signals';
import { type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { formatFigure, formatTime } from '../editing/units.js';
import { fieldName, figureOf, messages, secondsText, slotLabel } from '../messages/index.js';
import { servoName } from '../messages/names.js';
import { motorStopOf, reachedAt } from './flight.js';
import type { TimelineModel } from './view-model.js';
import './readout.css';

interface MomentProps {
  readonly program: TimerProgram;
  readonly model: TimelineModel;
  readonly cursor: ReadonlySignal<number | null> | undefined;
  readonly selected: ProgramField | null;
}

/**
 * The one large figure of the timeline: the value of the held handle; else the time in question and what it has
 * reached; else the selected value.
 */
export function Moment({ program, model, cursor, selected }: MomentProps) {
  const { timeline, times } = messages.value;
  const { identity } = program;
  const { edit, finer = false } = model.moving.value ?? {};
  const time = model.asked.value ?? cursor?.value ?? null;
  const field = edit?.field ?? (time === null ? selected : null);
  if (!field && time === null) return <p class="timeline-readout hint">{timeline.ask}</p>;
  const { text, unit } = field ? figureOf(identity, field, valueAt(program, field) ?? 0) : formatFigure(time ?? 0, 1);
  return (
    <p class="timeline-readout">
      <strong>
        {text} <small>{unit ? times.units[unit] : field?.kind === 'position' && timeline.stepsUnit}</small>
      </strong>{' '}
      <span>{field ? fieldName(identity, field) : reachedText(program, time ?? 0)}</span>
      {finer && <em>{timeline.finer}</em>}
    </p>
  );
}

/** What a flight has reached at a time. */
function reachedText(program: TimerProgram, time: number): string {
  const { slot, certain } = reachedAt(program, time);
  return certain ? slotLabel(program.identity, slot) : messages.value.timeline.notKnown;
}

/** For screen readers: what a key has asked about. */
export function Spoken({ program, model }: Pick<MomentProps, 'program' | 'model'>) {
  const spoken = model.spoken.value;
  return (
    <p class="visually-hidden" role="status">
      {spoken && ('time' in spoken ? momentText(program, spoken.time) : servoName(spoken.servo))}
    </p>
  );
}

/** The picture in one sentence. */
export function descriptionOf(program: TimerProgram): string {
  const { timeline } = messages.value;
  const { functions, servos } = program.identity;
  const stop = motorStopOf(program);
  const said = {
    servos: timeline.servos({ count: servos }),
    functions: timeline.functions({ count: functions - 1 }),
    dt: secondsText(formatTime(program.times[functions] ?? 0)),
  };
  if (stop === null) return timeline.description(said);
  return timeline.descriptionMotor({ ...said, motorStop: secondsText(formatTime(stop)) });
}

/** For screen readers: a time, what it has reached, and the positions of all servos. */
function momentText(program: TimerProgram, time: number): string {
  const { slot, certain } = reachedAt(program, time);
  const servos = program.positions.map((row, servo) => `${servoName(servo)} ${row[slot] ?? 0}`);
  return [secondsText(formatTime(time)), reachedText(program, time), ...(certain ? servos : [])].join(', ');
}
