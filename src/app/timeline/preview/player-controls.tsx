import { useMemo } from 'preact/hooks';
import type { TimerProgram } from '../../../program/index.js';
import { formatTime } from '../../editing/units.js';
import { messages } from '../../messages/index.js';
import { stretchedScale } from '../scale.js';
import { Icon } from '../tools.js';
import { endOf, eventsBetween, marksOf } from './flight.js';
import { type Player, SPEEDS } from './player.js';
import './player-controls.css';

interface PlayerControlsProps {
  readonly program: TimerProgram;
  readonly player: Player;
}

/** Play and pause, from event to event, how fast, and where. */
export function PlayerControls({ program, player }: PlayerControlsProps) {
  const { preview } = messages.value;
  const back = (): void => {
    player.pause();
    player.seek(eventsBetween(program, 0, player.time.peek() - 1).at(-1)?.time ?? 0);
  };
  const forward = (): void => {
    player.pause();
    player.seek(eventsBetween(program, player.time.peek(), endOf(program))[0]?.time ?? endOf(program));
  };
  return (
    <div class="preview-controls">
      <Scrubber program={program} player={player} />
      <div class="buttons">
        <button type="button" class="chip" aria-label={preview.back} onClick={back}>
          <Icon path="M5 4V16M16 4L8 10L16 16Z" />
        </button>
        <PlayButton player={player} />
        <button type="button" class="chip" aria-label={preview.forward} onClick={forward}>
          <Icon path="M15 4V16M4 4L12 10L4 16Z" />
        </button>
      </div>
      <SpeedChoice player={player} />
    </div>
  );
}

function PlayButton({ player }: { readonly player: Player }) {
  const { preview } = messages.value;
  return (
    <button type="button" class="primary preview-play" onClick={() => player.toggle()}>
      {player.playing.value ? preview.pause : preview.play}
    </button>
  );
}

function SpeedChoice({ player }: { readonly player: Player }) {
  const { preview } = messages.value;
  return (
    <fieldset class="preview-speed">
      <legend class="visually-hidden">{preview.speed}</legend>
      <div class="segments">
        {SPEEDS.map((speed) => (
          <button
            type="button"
            key={speed}
            aria-pressed={speed === player.speed.value}
            onClick={() => player.setSpeed(speed)}
          >
            {preview.times(speed)}
          </button>
        ))}
      </div>
    </fieldset>
  );
}

/**
 * The slider has this many places. They are spread over the flight as on the timeline, so that short steps can be
 * found.
 */
const PLACES = 500;
const MIN_GAP = 0.05;

function Scrubber({ program, player }: PlayerControlsProps) {
  const { preview, seconds } = messages.value;
  const scale = useMemo(() => stretchedScale(marksOf(program), { minGap: MIN_GAP, runOut: MIN_GAP }), [program]);
  const time = player.time.value;
  return (
    <input
      type="range"
      class="preview-scrubber"
      min={0}
      max={PLACES}
      value={Math.round(scale.place(time) * PLACES)}
      aria-label={preview.time}
      aria-valuetext={seconds(formatTime(time))}
      onInput={(event) => player.seek(Math.round(scale.time(Number(event.currentTarget.value) / PLACES)))}
    />
  );
}
