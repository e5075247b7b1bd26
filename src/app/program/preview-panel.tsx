import { batch, useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { fieldKey, type ProgramField, type TimerProgram } from '../../program/index.js';
import type { Session } from '../session/session.js';
import { Kept } from '../timeline/kept.js';
import { timeOf } from '../timeline/preview/flight.js';
import { FlightPreview } from '../timeline/preview/flight-preview.js';
import type { Player } from '../timeline/preview/player.js';

interface PreviewPanelProps {
  readonly session: Session;
  readonly program: TimerProgram;
  readonly player: Player;
  /** The field that has the focus elsewhere on the screen: the preview shows its time. */
  readonly selected: ProgramField | null;
}

/** The flight of the program, with the servos as the pilot has named them. */
export function PreviewPanel({ session, program, player, selected }: PreviewPanelProps) {
  const { servoUses } = session;
  const key = selected && fieldKey(selected);
  const time = selected && timeOf(program, selected);
  const drawn = useSignal(program);
  // After the picture of what was pressed; the program and its time together: else a mark that is moved is on both
  // sides of what it stands for, in turn.
  useEffect(
    () =>
      batch(() => {
        if (time !== null) player.take(time);
        drawn.value = program;
      }),
    [player, key, time, program],
  );
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
