import { batch, useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField, type TimerProgram } from '../../program/index.js';
import { whenIdle } from '../browser/when-idle.js';
import type { Session } from '../session/session.js';
import { Kept } from '../timeline/kept.js';
import { flightEnd, timeOf } from '../timeline/preview/flight.js';
import { FlightPreview } from '../timeline/preview/flight-preview.js';
import type { Player } from '../timeline/preview/player.js';

interface PreviewPanelProps {
  readonly session: Session;
  readonly program: TimerProgram;
  readonly player: Player;
  /** The field that has the focus elsewhere on the screen: the preview shows its time. */
  readonly selected: ProgramField | null;
}

/** What goes by faster than this is not waited for: somebody types or drags. Milliseconds. */
const IDLE_WITHIN = 100;

/** The flight of the program, with the servos as the pilot has named them. */
export function PreviewPanel({ session, program, player, selected }: PreviewPanelProps) {
  const { servoUses } = session;
  const key = selected && fieldKey(selected);
  const time = selected && timeOf(program, selected);
  const drawn = useSignal(program);
  const latest = useRef({ time, program });
  latest.current = { time, program };
  const waiting = useRef<(() => void) | null>(null);
  // Once the picture of what was pressed or dragged is drawn, and there is time.
  useEffect(() => {
    waiting.current ??= whenIdle(() => {
      waiting.current = null;
      const { time, program } = latest.current;
      // All of it together: else a mark that is moved is on both sides of what it stands for, in turn.
      batch(() => {
        player.setEnd(flightEnd(program));
        if (time !== null) player.take(time);
        drawn.value = program;
      });
    }, IDLE_WITHIN);
  }, [player, key, time, program]);
  useEffect(() => () => waiting.current?.(), []);
  const shown = drawn.value.identity === program.identity ? drawn.value : program;
  const named = servoUses.named.value;
  return (
    // Not drawn again for another cell: what changes then, follows the player.
    <Kept
      on={[shown, player, named, servoUses]}
      draw={() => <FlightPreview {...{ player, named }} program={shown} onName={(uses) => servoUses.say(uses)} />}
    />
  );
}
