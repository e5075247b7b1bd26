import { batch, computed, type ReadonlySignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { differences, type ProgramField, type TimerProgram } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { messages } from '../messages/index.js';
import { dutyName } from '../messages/names.js';
import { flightEnd, timeOf } from '../timeline/flight.js';
import { FlightPreview } from '../timeline/preview/flight-preview.js';
import { Timeline, type TimelineProps } from '../timeline/timeline.js';
import type { Standing } from '../timer/standing.js';
import type { Trials } from '../timer/trials.js';
import { useLate } from '../ui/use-late.js';
import type { Session } from '../work/session.js';
import type { ProgramPicture } from './program-picture.js';
import './timeline-panel.css';

interface TimelinePanelProps {
  readonly session: Session;
  /** Positions that were tried while the servos followed. */
  readonly trials: Trials;
  readonly picture: ProgramPicture;
  /** The focused field elsewhere on the screen. */
  readonly selected: ReadonlySignal<ProgramField | null>;
  readonly onSelect: (field: ProgramField) => void;
}

/** The program on the screen over time, with what the timer holds behind it, and the flight preview. */
export function TimelinePanel(props: TimelinePanelProps) {
  const { session, trials, picture, selected: field, onSelect } = props;
  const { editor, servoUses } = session;
  const { player } = picture;
  // The picture comes one frame late: it is drawn once, after the field that has changed or got the focus.
  const shown = useMemo(
    () =>
      computed(() => ({
        program: editor.working.value,
        ...heldBefore(editor, trials),
        sure: session.standing.value.sure,
        selected: field.value,
      })),
    [session, trials, field],
  );
  const [late, catchUp] = useLate(shown);
  const { program, held, isTrial, sure, selected } =
    late.program?.identity === editor.identity.value ? late : shown.peek();
  const overlay = useOverlay({ held, isTrial, sure });
  const named = servoUses.named.value;
  const names = useMemo(() => named?.map(dutyName), [named]);
  // Before anything is drawn: otherwise a moved mark would for a moment disagree with what it stands for.
  useMemo(() => {
    if (!program) return;
    batch(() => {
      player.setEnd(flightEnd(program));
      if (selected) player.take(timeOf(program, selected));
    });
  }, [player, program, selected]);
  // Not drawn again for another cell: the player updates what changes then.
  const preview = useMemo(
    () => program && <FlightPreview {...{ program, player, named }} onName={(uses) => servoUses.say(uses)} />,
    [program, player, named, servoUses],
  );
  if (!program) return null;
  return (
    <div class="timeline-panel">
      <Timeline
        {...{ program, selected, onSelect, overlay, names }}
        model={picture.timeline}
        cursor={player.cursor}
        now={() => editor.working.peek() ?? program}
        onEdit={(edit, phase) => {
          // A movement that comes back to its beginning is no step.
          const isNone = phase === 'back' && editor.abandon(edit.group);
          if (!isNone) editor.apply(edit);
          // A handle that is held stays held.
          catchUp();
          if (phase !== 'moving') editor.settle();
        }}
      />
      {preview}
    </div>
  );
}

interface Behind {
  /** What the timer holds, if it differs from the program. In a trial: what it held before. */
  readonly held: TimerProgram | null;
  /** Whether the servos follow, or it is not decided yet whether the tried positions stay. */
  readonly isTrial: boolean;
  readonly sure: Standing['sure'];
}

/** In a trial the timer already holds what was tried, so the picture shows what it held before. */
function heldBefore(editor: Editor, trials: Trials): Pick<Behind, 'held' | 'isTrial'> {
  const trial = trials.current.value;
  const { value: working } = editor.working;
  if (!trial || !working) {
    // A program that was made here was never in a timer.
    const isDrawn = editor.changes.value.length > 0 && editor.madeAt.value === null;
    return { held: isDrawn ? editor.baseline.value : null, isTrial: false };
  }
  return { held: differences(trial.before, working).length > 0 ? trial.before : null, isTrial: true };
}

/** What the timer holds, behind the program, and its name. */
function useOverlay({ held, isTrial, sure }: Behind): TimelineProps['overlay'] {
  const { knowledge, timeline } = messages.value;
  return useMemo(() => {
    const name = isTrial ? timeline.compareBefore : knowledge.held[sure === 'now' ? 'now' : 'once'];
    return held && { program: held, name, uncertain: sure === 'not' && !isTrial };
  }, [held, isTrial, knowledge, timeline, sure]);
}
