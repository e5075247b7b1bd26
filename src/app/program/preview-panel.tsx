import { batch, type ReadonlySignal, useSignal } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';
import { fieldKey, type ProgramField, type TimerProgram } from '../../program/index.js';
import { whenIdle } from '../browser/when-idle.js';
import type { Session } from '../session/session.js';
import { flightEnd, timeOf } from '../timeline/flight.js';
import { FlightPreview } from '../timeline/preview/flight-preview.js';
import type { Player } from '../timeline/preview/player.js';

interface PreviewPanelProps {
  readonly session: Session;
  /** As it is drawn around the preview: a frame late. */
  readonly program: TimerProgram;
  readonly player: Player;
  /** The focused field elsewhere on the screen: the preview shows its time. */
  readonly selected: ReadonlySignal<ProgramField | null>;
}

/** It waits until nothing has changed for so long, and then at most so long for an idle browser. In milliseconds. */
const REST = 250;
const IDLE_WITHIN = 100;

/** The flight of the program, with the pilot's names for the servos. */
export function PreviewPanel({ session, program, player, selected }: PreviewPanelProps) {
  const { editor, servoUses } = session;
  const drawn = useSignal(program);
  const catchUp = useMemo(() => {
    let told = { program, field: '' };
    return (): void => {
      const now = editor.working.peek() ?? told.program;
      const cell = selected.peek();
      const field = cell ? fieldKey(cell) : '';
      if (told.program === now && told.field === field) return;
      told = { program: now, field };
      // All at once: otherwise a moved mark would for a moment disagree with what it stands for.
      batch(() => {
        player.setEnd(flightEnd(now));
        if (cell) player.take(timeOf(now, cell));
        drawn.value = now;
      });
    };
  }, [editor, selected, player]);
  // Not between two keys, nor while a mark is dragged: it takes as long to draw as the picture, and the next key would
  // wait for it.
  const field = selected.value;
  useEffect(() => {
    let cancel = (): void => clearTimeout(rest);
    const rest = setTimeout(() => {
      cancel = whenIdle(catchUp, IDLE_WITHIN);
    }, REST);
    return () => cancel();
  }, [catchUp, field, program]);
  const shown = drawn.value.identity === program.identity ? drawn.value : program;
  const named = servoUses.named.value;
  // Not drawn again for another cell: the player updates what changes then.
  return useMemo(
    () => (
      <FlightPreview {...{ player, named }} program={shown} onUse={catchUp} onName={(uses) => servoUses.say(uses)} />
    ),
    [shown, player, named, servoUses, catchUp],
  );
}
