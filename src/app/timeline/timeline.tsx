import type { ReadonlySignal } from '@preact/signals';
import { useEffect, useId, useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField, type TimerProgram } from '../../program/index.js';
import { messages } from '../messages/index.js';
import type { OnEdit, Shown } from './drag.js';
import { timeOf } from './flight.js';
import { geometryOf, leastHeightOf, measuresOf } from './geometry.js';
import { Handles } from './handles.js';
import { fieldOf, KeyControl } from './key-control.js';
import { Crosshair, Picture } from './picture.js';
import { PointerControl } from './pointer-control.js';
import { descriptionOf, Moment, Spoken } from './readout.js';
import { TimelineNotes } from './timeline-notes.js';
import { Tools } from './tools.js';
import { useSize } from './use-size.js';
import { TimelineModel } from './view-model.js';
import './timeline.css';

export interface TimelineProps {
  readonly program: TimerProgram;
  /**
   * Gives the present program, because `program` may be a moment old. A handle that is taken begins there. Needed where
   * values can be changed.
   */
  readonly now?: (() => TimerProgram) | undefined;
  /** A second program, drawn faintly behind the first: what the timer holds, or a saved one. */
  readonly overlay?:
    | {
        readonly program: TimerProgram;
        readonly name: string;
        /** Whether to draw it dashed, because it may be out of date. */
        readonly uncertain?: boolean;
      }
    | null
    | undefined;
  /**
   * A time of the flight in hundredths of a second, marked by a line.
   * The time that a pointer asks about takes its place.
   */
  readonly cursor?: ReadonlySignal<number | null> | undefined;
  readonly selected?: ProgramField | null | undefined;
  /**
   * A handle has moved. While it is held the calls are not final. The last call gives the value at which it was
   * released, or the first value if it was put back. Absent when nothing can be changed.
   */
  readonly onEdit?: OnEdit | undefined;
  /** A handle has got the focus. */
  readonly onSelect?: ((field: ProgramField) => void) | undefined;
  /** Its name, where there are several. */
  readonly title?: string | undefined;
  /** The pilot's names for what each servo moves: “tailplane”. */
  readonly names?: readonly string[] | undefined;
  /** What the pilot looks at, when that outlasts this picture. */
  readonly model?: TimelineModel | undefined;
}

/** The program over time: a lane for each servo, marks for functions, motor stop and DT. To read and to edit. */
export function Timeline({ program, overlay = null, cursor, names, onEdit, onSelect, ...more }: TimelineProps) {
  const { timeline } = messages.value;
  const { now = () => program, title = timeline.title } = more;
  const selected = more.selected && more.selected.kind !== 'idleThrottle' ? more.selected : null;
  const id = useId();
  const model = useMemo(() => more.model ?? new TimelineModel(), [more.model]);
  const room = useRef<HTMLDivElement>(null);
  const svg = useRef<SVGSVGElement>(null);
  const size = useSize(room);

  const held = model.moving.value?.scale;
  const measures = measuresOf(program, size);
  const geometry = geometryOf(program, measures, {
    front: Math.min(model.front.value, program.identity.servos - 1),
    names,
    selected,
    behind: overlay?.program ?? null,
    view: model.view.value,
    scale: held,
  });
  const { scale } = geometry.layout;
  const anchor = (): number | undefined => {
    const time = model.asked.peek() ?? (selected && timeOf(program, selected));
    return time === null ? undefined : scale.place(time);
  };

  const shown = useRef<Shown | null>(null);
  const pointer = useMemo(() => new PointerControl(model, () => shown.current), [model]);
  const keys = useMemo(() => new KeyControl(model, () => shown.current), [model]);
  useLayoutEffect(() => {
    shown.current = svg.current && { svg: svg.current, geometry, now, onEdit, anchor };
  });
  useEffect(() => {
    const { current } = svg;
    // Only a listener that is not passive can stop the page from scrolling.
    current?.addEventListener('touchstart', pointer.touch, { passive: false });
    return () => {
      current?.removeEventListener('touchstart', pointer.touch);
      pointer.cancel();
      keys.up();
      model.leave();
    };
  }, []);
  useEffect(() => {
    if (!selected || model.moving.peek()) return;
    if (selected.kind === 'position') model.bringToFront(selected.servo);
    model.reveal(scale.place(timeOf(program, selected)));
  }, [selected && fieldKey(selected)]);

  const { width, height } = measures;
  const least = `max(var(--picture), ${leastHeightOf(program)}px)`;
  return (
    <section class={`timeline panel ${overlay?.uncertain ? 'uncertain-behind' : ''}`} aria-label={title}>
      <div class="row gap-3 timeline-top">
        <div class="timeline-moment">
          <Moment program={program} model={model} cursor={cursor} selected={selected} />
        </div>
        <Tools model={model} anchor={anchor} />
      </div>
      <div
        class="timeline-room"
        ref={room}
        // The content below may change its height: a held handle must stay under the finger.
        style={held ? { flex: 'none', height: `${height}px` } : { minHeight: least }}
      >
        {/* biome-ignore lint/a11y/useSemanticElements: a picture with handles in it is no fieldset */}
        <svg
          ref={svg}
          width={width}
          height={height}
          viewBox={`0 0 ${width} ${height}`}
          role="group"
          tabindex={0}
          aria-label={timeline.picture}
          aria-describedby={`${id}-about`}
          class="picture"
          onPointerDown={pointer.down}
          onPointerMove={pointer.move}
          onPointerUp={pointer.up}
          onPointerCancel={pointer.lost}
          onPointerLeave={pointer.leave}
          // The nearest handle gets the focus, not the topmost one.
          onMouseDown={(event) => event.preventDefault()}
          onKeyDown={keys.down}
          onKeyUp={keys.up}
          onFocusIn={({ target }) => {
            const field = shown.current && fieldOf(target, shown.current);
            if (!field) return;
            model.setEntered(true);
            model.reveal(scale.place(timeOf(program, field)));
            onSelect?.(field);
          }}
          onFocusOut={(event) => {
            const next = event.relatedTarget as Node | null;
            keys.up();
            model.setEntered(next !== svg.current && (svg.current?.contains(next) ?? false));
          }}
        >
          <Picture {...geometry} />
          <Crosshair {...geometry} timeNow={() => model.asked.value ?? cursor?.value ?? null} />
          {onEdit && <Handles geometry={geometry} entered={model.entered.value} />}
        </svg>
      </div>
      <p class="visually-hidden" id={`${id}-about`}>
        {descriptionOf(program)} {timeline.keysToEdit}
      </p>
      <Spoken program={program} model={model} />
      <TimelineNotes program={program} />
      <div class="timeline-foot">
        {overlay && (
          // The name of the second program, beside a piece of its line.
          <p class="hint timeline-behind">
            <svg class="overlay" width="26" height="8" aria-hidden="true">
              <path d="M1 4H25" />
            </svg>
            {overlay.name}
          </p>
        )}
      </div>
    </section>
  );
}
