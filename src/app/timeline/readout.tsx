import type { ReadonlySignal } from '@preact/signals';
import { type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { formatFigure, formatTime } from '../editing/units.js';
import { fieldName, figureOf, messages, slotLabel } from '../messages/index.js';
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
  const { edit, finer } = model.moving.value ?? {};
  const time = model.asked.value ?? cursor?.value ?? null;
  if (edit) return <ValueFigure program={program} field={edit.field} finer={finer} />;
  if (time !== null) {
    const { text, unit } = formatFigure(time, 1);
    return <Figure text={text} unit={times.units[unit]} what={reachedText(program, time)} />;
  }
  if (selected) return <ValueFigure program={program} field={selected} />;
  return <p class="timeline-readout hint">{timeline.ask}</p>;
}

interface ValueFigureProps {
  readonly program: TimerProgram;
  readonly field: ProgramField;
  /** Whether it is held, and moves less than the pointer. */
  readonly finer?: boolean | undefined;
}

function ValueFigure({ program, field, finer = false }: ValueFigureProps) {
  const { timeline, times } = messages.value;
  const { text, unit } = figureOf(program.identity, field, valueAt(program, field) ?? 0);
  const shownUnit = unit ? times.units[unit] : field.kind === 'position' ? timeline.stepsUnit : '';
  return (
    <Figure text={text} unit={shownUnit} what={fieldName(program.identity, field)} more={finer && timeline.finer} />
  );
}

interface FigureProps {
  readonly text: string;
  readonly unit: string;
  readonly what: string;
  readonly more?: string | false;
}

function Figure({ text, unit, what, more = false }: FigureProps) {
  return (
    <p class="timeline-readout">
      <strong>
        {text} <small>{unit}</small>
      </strong>{' '}
      <span>{what}</span>
      {more && <em>{more}</em>}
    </p>
  );
}

/** What a flight has reached at a time. */
function reachedText(program: TimerProgram, time: number): string {
  const { slot, certain } = reachedAt(program, time);
  return certain ? slotLabel(program.identity, slot) : messages.value.timeline.notKnown;
}

interface SpokenProps {
  readonly program: TimerProgram;
  readonly model: TimelineModel;
}

/** For screen readers: what a key has asked about. */
export function Spoken({ program, model }: SpokenProps) {
  const spoken = model.spoken.value;
  return (
    <p class="visually-hidden" role="status">
      {spoken && ('time' in spoken ? momentText(program, spoken.time) : messages.value.servoName(spoken.servo))}
    </p>
  );
}

/** The picture in one sentence. */
export function descriptionOf(program: TimerProgram): string {
  const { timeline, seconds } = messages.value;
  const { functions, servos } = program.identity;
  const stop = motorStopOf(program);
  return timeline.description({
    servos,
    functions: functions - 1,
    dt: seconds(formatTime(program.times[functions] ?? 0)),
    motorStop: stop === null ? null : seconds(formatTime(stop)),
  });
}

/** For screen readers: a time, what it has reached, and the positions of all servos. */
function momentText(program: TimerProgram, time: number): string {
  const { seconds, servoName } = messages.value;
  const { slot, certain } = reachedAt(program, time);
  const servos = program.positions.map((row, servo) => `${servoName(servo)} ${row[slot] ?? 0}`);
  return [seconds(formatTime(time)), reachedText(program, time), ...(certain ? servos : [])].join(', ');
}
