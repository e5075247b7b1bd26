import { type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { formatTime } from '../editing/units.js';
import { fieldLabel, messages, slotLabel } from '../messages/index.js';
import { servoClass } from './layers.js';
import { motorStopOf, reachedAt } from './preview/flight.js';
import type { TimelineModel } from './view-model.js';
import './readout.css';

interface ReadoutProps {
  readonly program: TimerProgram;
  /** The time that is asked about; null for none. */
  readonly time: number | null;
  /** The field in hand; it goes before the time. */
  readonly moving: ProgramField | null;
}

/**
 * The one large figure of the timeline: the value in hand, else the time that is asked about and what it has reached.
 */
function Readout({ program, time, moving }: ReadoutProps) {
  const { timeline, seconds } = messages.value;
  if (moving) {
    const value = valueAt(program, moving) ?? 0;
    const figure = moving.kind === 'time' ? seconds(formatTime(value)) : String(value);
    return <Figure figure={figure} what={fieldLabel(program.identity, moving)} />;
  }
  if (time === null) return <p class="timeline-readout hint">{timeline.ask}</p>;
  return <Figure figure={seconds(formatTime(time))} what={reachedText(program, time)} />;
}

function Figure({ figure, what }: { figure: string; what: string }) {
  return (
    <p class="timeline-readout">
      <strong>{figure}</strong> <span>{what}</span>
    </p>
  );
}

/** What a flight has reached at a time. */
function reachedText(program: TimerProgram, time: number): string {
  const { slot, certain } = reachedAt(program, time);
  return certain ? slotLabel(program.identity, slot) : messages.value.timeline.notKnown;
}

interface MomentProps {
  readonly program: TimerProgram;
  readonly model: TimelineModel;
  readonly cursor: number | null;
}

/** {@link Readout} of what the model asks about. */
export function Moment({ program, model, cursor }: MomentProps) {
  const moving = model.moving.value?.edit.field ?? null;
  return <Readout program={program} time={model.asked.value ?? cursor} moving={moving} />;
}

/** {@link Legend} of what the model asks about. */
export function MomentLegend(props: MomentProps & { readonly front: number; readonly overlay: string | null }) {
  const { program, model, cursor, front, overlay } = props;
  return (
    <Legend
      {...{ program, front, overlay }}
      time={model.asked.value ?? cursor}
      onFront={(servo) => model.bringToFront(servo)}
    />
  );
}

/** What a key has asked about, for who does not see it. */
export function Spoken({ program, model }: Omit<MomentProps, 'cursor'>) {
  const time = model.spoken.value;
  return (
    <p class="visually-hidden" role="status">
      {time !== null && momentText(program, time)}
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

/** A time, what it has reached, and where all servos stand: for who does not see the picture. */
function momentText(program: TimerProgram, time: number): string {
  const { seconds, servoName, timeline } = messages.value;
  const { slot, certain } = reachedAt(program, time);
  const servos = program.positions.map((row, servo) => timeline.stands(servoName(servo), row[slot] ?? 0));
  return [seconds(formatTime(time)), reachedText(program, time), ...(certain ? servos : [])].join(', ');
}

interface LegendProps {
  readonly program: TimerProgram;
  readonly time: number | null;
  readonly front: number;
  readonly onFront: (servo: number) => void;
  /** What lies behind, by its name. */
  readonly overlay: string | null;
}

/** More servos than this are chosen from a list. */
const MOST_CHIPS = 8;

/** Which line is which, where each servo stands at the time that is asked about, and which one is in front. */
function Legend({ program, time, front, onFront, overlay }: LegendProps) {
  const { timeline, servoName } = messages.value;
  const slot = time === null ? null : reachedAt(program, time);
  const servos = program.positions.map((row, servo) => ({
    servo,
    value: slot === null ? '' : slot.certain ? String(row[slot.slot] ?? '') : timeline.unknownValue,
  }));
  return (
    <div class="timeline-legend">
      {servos.length > MOST_CHIPS ? (
        <label class="timeline-servos">
          {timeline.front}
          <select value={front} onChange={(event) => onFront(Number(event.currentTarget.value))}>
            {servos.map(({ servo, value }) => (
              <option key={servo} value={servo}>
                {timeline.stands(servoName(servo), value)}
              </option>
            ))}
          </select>
        </label>
      ) : (
        <fieldset class="timeline-servos">
          <legend class="visually-hidden">{timeline.front}</legend>
          {servos.map(({ servo, value }) => (
            <button
              type="button"
              key={servo}
              class={`chip ${servoClass(servo)}`}
              aria-pressed={servo === front}
              onClick={() => onFront(servo)}
            >
              <svg class="swatch" width="26" height="8" aria-hidden="true">
                <path class="held" d="M1 4H25" />
              </svg>
              <span>{servoName(servo)}</span>
              <span class="chip-value">{value}</span>
            </button>
          ))}
        </fieldset>
      )}
      {overlay !== null && (
        <p class="timeline-behind">
          <svg class="swatch overlay" width="26" height="8" aria-hidden="true">
            <path d="M1 4H25" />
          </svg>
          {overlay}
        </p>
      )}
    </div>
  );
}
