import { computed, useSignal } from '@preact/signals';
import { useEffect, useId, useMemo } from 'preact/hooks';
import type { ServoUse, TimerProgram } from '../../../program/index.js';
import { messages, momentText, slotLabel } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import { dutyName, servoName } from '../../messages/names.js';
import { eventsBetween, motorStopOf, reachedAt } from '../flight.js';
import { servoColour } from '../servo-colour.js';
import { ModelSketch } from './model-sketch.js';
import type { Player } from './player.js';
import { PlayerControls } from './player-controls.js';
import { ServoDialog } from './servo-dialog.js';
import { guessedUses, movedAtDt, turnsAt } from './surfaces.js';
import './flight-preview.css';

export interface FlightPreviewProps {
  readonly program: TimerProgram;
  /** Its end is that of the program. */
  readonly player: Player;
  /** What each servo moves, as the pilot says; null when that has to be guessed. */
  readonly named: readonly ServoUse[] | null;
  readonly onName: (uses: readonly ServoUse[] | null) => void;
}

/** With more servos, the list does not say what they move. */
const MANY = 4;

/**
 * The flight of the program: what the servos move, when the motor stops, and what comes when. Drawn again when
 * something happens, not at each frame.
 */
export function FlightPreview({ program, player, named, onName }: FlightPreviewProps) {
  const { preview } = moreMessages.value;
  const { findings } = messages.value;
  const { identity } = program;
  const id = useId();
  const naming = useSignal(false);
  const guess = useMemo(() => guessedUses(program), [program]);
  useEffect(() => () => player.pause(), [player]);
  const uses = named ?? guess;
  const stop = motorStopOf(program);
  const slot = useMemo(() => computed(() => reachedAt(program, player.shown.value).slot), [program, player]).value;
  const motor = useMemo(() => computed(() => player.shown.value < (stop ?? 0)), [player, stop]).value;
  const isDt = slot === identity.functions;
  const flies = stop === null ? preview.flies : preview.motor[`${motor}`];
  // A DT at which no servo moves brings no model down.
  const comesDown = isDt && movedAtDt(program).length > 0;
  return (
    <section class="preview" aria-labelledby={id}>
      <h2 class="visually-hidden" id={id}>
        {preview.title}
      </h2>
      <div class="row">
        <div class="preview-model">
          <ModelSketch
            turned={turnsAt(program, slot, uses)}
            propeller={identity.timerClass !== 'E'}
            motorRuns={stop === null ? null : motor}
            turning={player.playing.value}
            comesDown={comesDown}
          />
          <p class="hint">
            {preview.guessed}{' '}
            <button type="button" class="quiet" onClick={() => (naming.value = true)}>
              {preview.nameServos}
            </button>
          </p>
        </div>
        <div class="preview-facts">
          <div>
            <Clock player={player} />
            <p class={isDt && !comesDown ? 'bad-text' : undefined}>
              {comesDown ? <strong>{preview.comesDown}</strong> : isDt ? findings['dt-moves-nothing'] : flies}
            </p>
            <Happening program={program} player={player} />
          </div>
          <ul class={uses.length > MANY ? 'many' : ''}>
            {uses.map((use, servo) => (
              <li key={servoName(servo)} {...servoColour(servo)}>
                <b>{servoName(servo)}</b> <span class="duty">{dutyName(use)}</span>{' '}
                <span class="stands">{program.positions[servo]?.[slot]}</span>
              </li>
            ))}
          </ul>
        </div>
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

type ShownProps = Pick<FlightPreviewProps, 'program' | 'player'>;

function Clock({ player }: Pick<ShownProps, 'player'>) {
  return <strong class="preview-clock">{momentText(player.shown.value)}</strong>;
}

/** The latest event. A screen reader hears it during a flight, but not while the pilot only looks. */
function Happening({ program, player }: ShownProps) {
  const text = useMemo(() => computed(() => happened(program, player.shown.value)), [program, player]);
  const isUnderWay = useMemo(() => computed(() => player.cursor.value !== null), [player]);
  return <p role={isUnderWay.value ? 'status' : undefined}>{text.value}</p>;
}

function happened(program: TimerProgram, time: number): string {
  const { timeline, program: words } = messages.value;
  const { preview } = moreMessages.value;
  if (!reachedAt(program, time).certain) return timeline.notKnown;
  const last = eventsBetween(program, -1, time).at(-1)?.time;
  if (last === undefined) return preview.launch;
  const names = eventsBetween(program, last - 1, last).map(({ slot }) =>
    slot > 0 ? slotLabel(program.identity, slot) : words.motorStop,
  );
  return preview.at({ what: names.join(', '), time: momentText(last) });
}
