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
  // After the picture of what was pressed.
  useEffect(() => {
    if (time !== null) player.take(time);
  }, [player, key, time]);
  const named = servoUses.named.value;
  return (
    // Not drawn again for another cell: what changes then, follows the player.
    <Kept
      on={[program, player, named, servoUses]}
      draw={() => <FlightPreview {...{ program, player, named }} onName={(uses) => servoUses.say(uses)} />}
    />
  );
}
