import { useMemo } from 'preact/hooks';
import type { TimerProgram } from '../../../program/index.js';
import { messages, momentText } from '../../messages/index.js';
import { moreMessages } from '../../messages/more.js';
import { Select } from '../../ui/choice.js';
import { Icon } from '../../ui/icon.js';
import { eventsBetween, flightEnd, marksOf } from '../flight.js';
import { stretchedScale } from '../scale.js';
import { type Player, SPEEDS } from './player.js';
import './player-controls.css';

interface PlayerControlsProps {
  readonly program: TimerProgram;
  readonly player: Player;
}

/** The controls: play and pause, previous and next event, place, speed. */
export function PlayerControls({ program, player }: PlayerControlsProps) {
  const { previous, next, pause } = messages.value;
  const { preview } = moreMessages.value;
  const back = (): void => {
    player.pause();
    player.seek(eventsBetween(program, 0, player.shown.peek() - 1).at(-1)?.time ?? 0);
  };
  const forward = (): void => {
    player.pause();
    player.seek(eventsBetween(program, player.shown.peek(), flightEnd(program))[0]?.time ?? flightEnd(program));
  };
  return (
    <div class="row preview-controls">
      <button type="button" class="primary" onClick={() => player.toggle()}>
        {player.playing.value ? pause : preview.play}
      </button>
      <button type="button" class="chip" aria-label={previous} onClick={back}>
        <Icon path="M5 4V16M16 4L8 10L16 16Z" />
      </button>
      <button type="button" class="chip" aria-label={next} onClick={forward}>
        <Icon path="M15 4V16M4 4L12 10L4 16Z" />
      </button>
      <Scrubber program={program} player={player} />
      <Select
        name={preview.speed}
        choices={SPEEDS}
        nameOf={(speed) => `${speed}×`}
        chosen={player.speed.value}
        onChoose={(speed) => player.setSpeed(speed)}
      />
    </div>
  );
}

/** How many places the slider has. They are spread as on the timeline, so that short steps can be found. */
const PLACES = 500;
const MIN_GAP = 0.05;

function Scrubber({ program, player }: PlayerControlsProps) {
  const { preview } = moreMessages.value;
  const scale = useMemo(() => stretchedScale(marksOf(program), { minGap: MIN_GAP, runOut: MIN_GAP }), [program]);
  const time = player.shown.value;
  return (
    <input
      type="range"
      class="preview-scrubber"
      min={0}
      max={PLACES}
      value={Math.round(scale.place(time) * PLACES)}
      aria-label={preview.time}
      aria-valuetext={momentText(time)}
      onInput={(event) => player.seek(Math.round(scale.time(Number(event.currentTarget.value) / PLACES)))}
    />
  );
}
