import type { TimerProgram } from '../../program/index.js';
import { motorStopOf, stagesOf } from './flight.js';
import type { Geometry } from './geometry.js';
import { Kept } from './kept.js';
import { type Layout, lineOf, tipsOf } from './layout.js';
import { servoClass } from './servo-class.js';
import './lines.css';

interface LinesProps {
  readonly geometry: Geometry;
  readonly front: number;
}

/** The lines of the servos, each in its lane. */
export function Lines({ geometry, front }: LinesProps) {
  const { program, stages, layout } = geometry;
  return (
    <g>
      {program.positions.map((row, servo) => (
        <Kept
          key={servo}
          on={[row.join(), stages, layout, servo === front]}
          draw={() => {
            const { line, back } = lineOf(program, stages, servo, layout);
            const tips = tipsOf(program, stages, servo, layout);
            return (
              <g class={`servo-line ${servoClass(servo)} ${servo === front ? 'front' : ''}`} data-servo={servo}>
                <path class="line" d={line} />
                {back !== '' && <path class="back" d={back} />}
                {tips !== '' && <path class="tip" d={tips} />}
              </g>
            );
          }}
        />
      ))}
    </g>
  );
}

interface OverlayProps {
  readonly program: TimerProgram;
  readonly layout: Layout;
  /** Whether to draw its motor stop. Dashes would show through the thin line of an equal one, as if it differed. */
  readonly hasStop: boolean;
}

/** A second program behind the first, thin and dashed: its lines, its DT and its motor stop. */
export function Overlay({ program, layout, hasStop }: OverlayProps) {
  const { top, bottom } = layout.box;
  const stages = stagesOf(program);
  const dt = stages.at(-1)?.from ?? 0;
  const stop = hasStop ? motorStopOf(program) : null;
  return (
    <g class="overlay">
      {program.positions.map((_, servo) => {
        const { line, back } = lineOf(program, stages, servo, layout);
        return <path key={servo} d={line + back} />;
      })}
      <path class="mark" d={`M${layout.x(dt)} ${top}V${bottom}`} />
      {stop !== null && <path class="mark" d={`M${layout.x(stop)} ${top}V${bottom}`} />}
    </g>
  );
}

/** A lower lane has no room for a word beside its line, in pixels. */
const WORD_ROOM = 40;

interface LaneNamesProps {
  readonly layout: Layout;
  /** The pilot's names for what each servo moves. */
  readonly names: readonly string[] | undefined;
}

/** What each servo moves, in its lane. The buttons of the lanes have the names of the servos. */
export function LaneNames({ layout, names }: LaneNamesProps) {
  return (
    <g class="lane-names">
      {layout.lanes.map(({ from, until }, servo) => {
        const name = names?.[servo];
        if (!name || until - from < WORD_ROOM) return null;
        return (
          <text key={from} x={layout.box.left + 14} y={from + 14} dy="0.35em">
            {name}
          </text>
        );
      })}
    </g>
  );
}
