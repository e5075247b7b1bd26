import { computed, useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect, useId, useLayoutEffect, useMemo } from 'preact/hooks';
import type { ServoUse, TimerProgram } from '../../../program/index.js';
import { dutyName, messages, momentText, slotLabel } from '../../messages/index.js';
import { eventsBetween, type FlightEvent, flightEnd, motorStopOf, reachedAt } from '../flight.js';
import { servoClass } from '../servo-class.js';
import { ModelSketch, type SurfaceAngle } from './model-sketch.js';
import type { Player } from './player.js';
import { PlayerControls } from './player-controls.js';
import { ServoDialog } from './servo-dialog.js';
import { guessedUses, isLetGo, movedAtDt, SURFACES, type Surface, servoOf, turnOf } from './surfaces.js';
import './flight-preview.css';

export interface FlightPreviewProps {
  readonly program: TimerProgram;
  readonly player: Player;
  /** What each servo moves, as the pilot says; null when that has to be guessed. */
  readonly named: readonly ServoUse[] | null;
  readonly onName: (uses: readonly ServoUse[] | null) => void;
}

/** With more servos, the list does not say what they move. */
const MANY = 4;

/** The flight of the program: what the servos move, when the motor stops, and what comes when. */
export function FlightPreview({ program, player, named, onName }: FlightPreviewProps) {
  const { preview } = messages.value;
  const id = useId();
  const naming = useSignal(false);
  const guess = useMemo(() => guessedUses(program), [program]);
  useLayoutEffect(() => player.setEnd(flightEnd(program)), [player, program]);
  useEffect(() => () => player.pause(), [player]);
  const uses = named ?? guess;
  return (
    <section class="preview" aria-labelledby={id}>
      <h2 class="visually-hidden" id={id}>
        {preview.title}
      </h2>
      <div class="preview-body">
        <Flight program={program} player={player} uses={uses}>
          <p>
            {preview.guessed}{' '}
            <button type="button" class="quiet" onClick={() => (naming.value = true)}>
              {preview.nameServos}
            </button>
          </p>
        </Flight>
        <PlayerControls program={program} player={player} />
      </div>
      <ServoDialog
        open={naming.value}
        uses={uses}
        onSave={(changed) => {
          naming.value = false;
          onName(changed);
        }}
        onCancel={() => (naming.value = false)}
      />
    </section>
  );
}

interface ShownProps {
  readonly program: TimerProgram;
  readonly player: Player;
}

interface FlightProps extends ShownProps {
  readonly uses: readonly ServoUse[];
  /** How far to trust the sketch. */
  readonly children: ComponentChildren;
}

/** The sketch and its explanation. Drawn again when something happens, not at each frame. */
function Flight({ program, player, uses, children }: FlightProps) {
  const { preview, servoName } = messages.value;
  const { identity } = program;
  const stop = motorStopOf(program);
  const reached = useMemo(() => computed(() => reachedAt(program, player.shown.value).slot), [program, player]);
  const motor = useMemo(() => computed(() => player.shown.value < (stop ?? 0)), [player, stop]);
  const slot = reached.value;
  const isDt = slot === identity.functions;
  const moved = movedAtDt(program);
  const turned = Object.fromEntries(
    SURFACES.map((surface) => {
      const degrees = turnOf(program, slot, surface, uses);
      return [surface, degrees === null ? null : { degrees, servo: servoOf(surface, uses) }];
    }),
  ) as Record<Surface, SurfaceAngle | null>;
  return (
    <>
      <div class="preview-model">
        <ModelSketch
          turned={turned}
          propeller={identity.timerClass !== 'E'}
          motorRuns={stop === null ? null : motor.value}
          turning={player.playing.value}
          comesDown={isDt && moved.length > 0}
          letGo={isDt && isLetGo(program, uses)}
        />
        {children}
      </div>
      <div class="preview-facts">
        <div>
          <Clock player={player} />
          {isDt ? <AtDt moved={moved} /> : <p>{stop === null ? preview.flies : preview.motor[`${motor.value}`]}</p>}
          <Happening program={program} player={player} />
        </div>
        <ul class={uses.length > MANY ? 'many' : ''}>
          {uses.map((use, servo) => (
            <li key={servoName(servo)} class={servoClass(servo)}>
              <b>{servoName(servo)}</b> <span class="duty">{dutyName(use)}</span>{' '}
              <span class="stands">{program.positions[servo]?.[slot]}</span>
            </li>
          ))}
        </ul>
      </div>
    </>
  );
}

/** A DT at which no servo moves brings no model down. */
function AtDt({ moved }: { readonly moved: readonly number[] }) {
  const { preview, findings } = messages.value;
  return moved.length > 0 ? (
    <p class="preview-dt">{preview.comesDown}</p>
  ) : (
    <p class="bad-text">{findings['dt-moves-nothing']({})}</p>
  );
}

function Clock({ player }: { readonly player: Player }) {
  return <strong class="preview-clock">{momentText(player.shown.value)}</strong>;
}

/** The latest event. A screen reader hears it during a flight, but not while the pilot only looks. */
function Happening({ program, player }: ShownProps) {
  const text = useMemo(() => computed(() => happened(program, player.shown.value)), [program, player]);
  const isUnderWay = useMemo(() => computed(() => player.cursor.value !== null), [player]);
  return <p role={isUnderWay.value ? 'status' : undefined}>{text.value}</p>;
}

function happened(program: TimerProgram, time: number): string {
  const { preview, timeline } = messages.value;
  if (!reachedAt(program, time).certain) return timeline.notKnown;
  const last = eventsBetween(program, -1, time).at(-1)?.time;
  return last === undefined ? preview.launch : `${namesAt(program, last)} ${preview.at(momentText(last))}`;
}

/** What happens at a time. */
function namesAt(program: TimerProgram, time: number): string {
  return eventsBetween(program, time - 1, time)
    .map((event) => eventName(program, event))
    .join(', ');
}

function eventName({ identity }: TimerProgram, event: FlightEvent): string {
  return event.kind === 'slot' ? slotLabel(identity, event.slot) : messages.value.program.motorStop;
}
