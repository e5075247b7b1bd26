import { messages } from '../messages/index.js';
import type { Layout } from './layout.js';
import { servoClass } from './servo-class.js';
import type { TimelineModel } from './view-model.js';
import './lane-buttons.css';

interface LaneButtonsProps {
  readonly layout: Layout;
  readonly front: number;
  readonly model: TimelineModel;
  /** The pilot's names for what each servo moves. */
  readonly names: readonly string[] | undefined;
}

/** The name of each servo at the left edge of its lane. A click selects the servo. */
export function LaneButtons({ layout, front, model, names }: LaneButtonsProps) {
  const { timeline, servoName } = messages.value;
  return (
    <fieldset class="lane-buttons">
      <legend class="visually-hidden">{timeline.front}</legend>
      {layout.lanes.map(({ from, until }, servo) => (
        <button
          type="button"
          key={servoName(servo)}
          class={servoClass(servo)}
          style={{
            top: `${from}px`,
            height: `${until - from}px`,
            width: `${layout.box.left}px`,
            // Between the position figures at the left edge of the selected lane.
            paddingBottom: `${servo === front ? (until - from) / 2 : 0}px`,
          }}
          aria-pressed={servo === front}
          aria-label={[servoName(servo), names?.[servo]].filter(Boolean).join(' ')}
          onClick={() => model.bringToFront(servo)}
        >
          {servoName(servo)}
        </button>
      ))}
    </fieldset>
  );
}
