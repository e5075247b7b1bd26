import { batch, useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
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
  /** The focused field elsewhere on the screen: the preview shows its time. */
  readonly selected: ProgramField | null;
}

/** It waits until nothing has changed for so long, and then at most so long for an idle browser. In milliseconds. */
const REST = 250;
const IDLE_WITHIN = 100;

/** The flight of the program, with the pilot's names for the servos. */
export function PreviewPanel({ session, program, player, selected }: PreviewPanelProps) {
  const { servoUses } = session;
  const key = selected && fieldKey(selected);
  const time = selected && timeOf(program, selected);
  const drawn = useSignal(program);
  // Not between two keys, nor while a mark is dragged: it takes as long to draw as the picture, and the next key would
  // wait for it.
  useEffect(() => {
    const was = player.cursor.peek();
    const act = (): void =>
      // All at once: otherwise a moved mark would for a moment disagree with what it stands for.
      batch(() => {
        player.setEnd(flightEnd(program));
        // Where the pilot has sought meanwhile, the preview stays.
        if (time !== null && player.cursor.peek() === was) player.take(time);
        drawn.value = program;
      });
    let cancel = (): void => clearTimeout(rest);
    const rest = setTimeout(() => {
      cancel = whenIdle(act, IDLE_WITHIN);
    }, REST);
    return () => cancel();
  }, [player, key, time, program]);
  const shown = drawn.value.identity === program.identity ? drawn.value : program;
  const named = servoUses.named.value;
  return (
    // Not drawn again for another cell: the player updates what changes then.
    <Kept
      on={[shown, player, named, servoUses]}
      draw={() => <FlightPreview {...{ player, named }} program={shown} onName={(uses) => servoUses.say(uses)} />}
    />
  );
}
