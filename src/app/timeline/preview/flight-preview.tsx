import { computed, effect, useSignal } from '@preact/signals';
import { useEffect, useId, useLayoutEffect, useMemo } from 'preact/hooks';
import type { TimerProgram } from '../../../program/index.js';
import { formatTime } from '../../editing/units.js';
import { messages, slotLabel } from '../../messages/index.js';
import { endOf, eventsBetween, type FlightEvent, motorStopOf, reachedAt } from './flight.js';
import { LinkageChoice } from './linkage-choice.js';
import { ModelSketch } from './model-sketch.js';
import { Player } from './player.js';
import { PlayerControls } from './player-controls.js';
import { deflection, type Linkages, SURFACES, type Surface, usualLinkages } from './surfaces.js';
import { TickSound } from './tick-sound.js';
import './flight-preview.css';

export interface FlightPreviewProps {
  readonly program: TimerProgram;
  /** What plays it, to be shared with a timeline; one of its own if there is none. */
  readonly player?: Player | undefined;
  /** Which servo moves what, where that is kept outside; else it is kept as long as this is on the screen. */
  readonly linkages?: Linkages | undefined;
  readonly onLinkages?: ((linkages: Linkages) => void) | undefined;
}

/** The flight as the program has it: what the servos move, when the motor stops, what comes when. */
export function FlightPreview({ program, player: given, linkages: kept, onLinkages }: FlightPreviewProps) {
  const { preview } = messages.value;
  const id = useId();
  const player = useMemo(() => given ?? new Player(), [given]);
  const own = useSignal<Linkages | null>(null);
  const linkages = kept ?? own.value ?? usualLinkages(program.identity.servos);
  useLayoutEffect(() => player.setEnd(endOf(program)), [player, program]);
  useEffect(() => () => player.pause(), [player]);
  return (
    <section class="preview" aria-labelledby={id}>
      <div>
        <h2 id={id}>{preview.title}</h2>
        <p class="hint">{preview.honest}</p>
      </div>
      <Model program={program} player={player} linkages={linkages} />
      <div class="preview-now">
        <Clock player={player} />
        <Happening program={program} player={player} />
      </div>
      <PlayerControls program={program} player={player} />
      <div class="preview-foot">
        <LinkageChoice
          servos={program.identity.servos}
          linkages={linkages}
          onChange={(changed) => {
            own.value = changed;
            onLinkages?.(changed);
          }}
        />
        <Sound program={program} player={player} />
      </div>
    </section>
  );
}

interface PlayedProps {
  readonly program: TimerProgram;
  readonly player: Player;
}

/** The sketch, drawn again when something happens and not at each frame. */
function Model({ program, player, linkages }: PlayedProps & { readonly linkages: Linkages }) {
  const { preview, servoName } = messages.value;
  const reached = useMemo(() => computed(() => reachedAt(program, player.time.value).slot), [program, player]);
  const motor = useMemo(() => computed(() => player.time.value < (motorStopOf(program) ?? 0)), [program, player]);
  const slot = reached.value;
  const deflections = Object.fromEntries(
    SURFACES.map((surface) => [surface, deflection(program, slot, linkages[surface])]),
  ) as Record<Surface, number | null>;
  return (
    <>
      <ModelSketch
        deflections={deflections}
        linkages={linkages}
        propeller={program.identity.timerClass !== 'E'}
        motorRuns={motor.value}
        turning={player.playing.value}
      />
      <ul class="preview-surfaces">
        {SURFACES.map((surface) => {
          const { servo } = linkages[surface];
          const position = servo === null ? undefined : program.positions[servo]?.[slot];
          const name = preview.surfaces[surface];
          return (
            <li key={surface}>
              {servo === null || position === undefined
                ? preview.surfaceStill(name)
                : preview.surfaceStands(name, servoName(servo), position)}
            </li>
          );
        })}
        {motorStopOf(program) !== null && <li>{motor.value ? preview.motorRuns : preview.motorStopped}</li>}
      </ul>
    </>
  );
}

function Clock({ player }: { readonly player: Player }) {
  return <strong class="preview-clock">{messages.value.seconds(formatTime(player.time.value))}</strong>;
}

/** What came last, said when it comes. */
function Happening({ program, player }: PlayedProps) {
  const { timeline } = messages.value;
  const text = useMemo(
    () =>
      computed(() => {
        const time = player.time.value;
        return reachedAt(program, time).certain ? lastText(program, time) : timeline.notKnown;
      }),
    [program, player, timeline],
  );
  return <span role="status">{text.value}</span>;
}

/** What happened last up to a time; all of it, where several things happened at once. */
function lastText(program: TimerProgram, time: number): string {
  const { preview, seconds } = messages.value;
  const events = eventsBetween(program, -1, time);
  const last = events.at(-1);
  if (!last) return preview.launch;
  const names = events.filter((event) => event.time === last.time).map((event) => eventName(program, event));
  return preview.at(names.join(', '), seconds(formatTime(last.time)));
}

function eventName({ identity }: TimerProgram, event: FlightEvent): string {
  return event.kind === 'slot' ? slotLabel(identity, event.slot) : messages.value.program.motorStop;
}

/** A tick for each thing that happens while it is played, a deeper one for DT; silent until it is switched on. */
function Sound({ program, player }: PlayedProps) {
  const on = useSignal(false);
  const sound = useMemo(() => new TickSound(), []);
  useEffect(() => () => sound.close(), []);
  useEffect(() => {
    let before = player.time.peek();
    return effect(() => {
      const time = player.time.value;
      const events = on.value && player.playing.peek() ? eventsBetween(program, before, time) : [];
      before = time;
      if (events.length === 0) return;
      sound.tick(events.some((event) => event.kind === 'slot' && event.slot === program.identity.functions));
    });
  }, [program, player]);
  return (
    <label class="timeline-even">
      <input
        type="checkbox"
        checked={on.value}
        onChange={(event) => {
          on.value = event.currentTarget.checked;
          if (on.value) sound.allow();
        }}
      />
      {messages.value.preview.sound}
    </label>
  );
}
