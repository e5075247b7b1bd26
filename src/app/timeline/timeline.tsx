import { useEffect, useId, useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField, type TimerProgram } from '../../program/index.js';
import { messages } from '../messages/index.js';
import type { OnEdit } from './drag.js';
import { geometryOf, measuresOf, scaleOf } from './geometry.js';
import { Handles } from './handles.js';
import { useGlide, useStable, useWidth } from './hooks.js';
import { HandleKeys, pictureKey } from './key-control.js';
import { Crosshair, Picture } from './layers.js';
import type { Target } from './pointer/gesture.js';
import { PointerControl } from './pointer/pointer-control.js';
import { timeOf } from './preview/flight.js';
import { descriptionOf, Moment, MomentLegend, Spoken } from './readout.js';
import { TimelineNotes, TimelineTable } from './timeline-table.js';
import { EvenSeconds, Tools } from './tools.js';
import { TimelineModel } from './view-model.js';
import './timeline.css';

export interface TimelineProps {
  readonly program: TimerProgram;
  /** The program by now, where `program` may be a moment behind: what is taken hold of begins there. */
  readonly now?: (() => TimerProgram) | undefined;
  /** A second program, drawn faint behind the first: what the timer holds, or a saved one. */
  readonly overlay?:
    | {
        readonly program: TimerProgram;
        readonly name: string;
        /** It is drawn dashed: nobody knows whether it is still so. */
        readonly uncertain?: boolean;
      }
    | null
    | undefined;
  /** A time of the flight in hundredths of a second, marked by a line; what a pointer asks about goes before it. */
  readonly cursor?: number | null | undefined;
  readonly selected?: ProgramField | null | undefined;
  /**
   * A handle has moved. While it is in hand the calls are not final. The last one is, and gives once more the value
   * with which the handle was let go, or the first one if it was put back. Absent when nothing can be changed.
   */
  readonly onEdit?: OnEdit | undefined;
  /** A handle has got the focus. */
  readonly onSelect?: ((field: ProgramField) => void) | undefined;
  /** The mouse has come over something that it could take hold of, or has left it: null. */
  readonly onPoint?: ((field: ProgramField | null) => void) | undefined;
  /** What it is called where there are several. */
  readonly title?: string | undefined;
  /** A small picture to be looked at, with nothing to take hold of. */
  readonly compact?: boolean | undefined;
}

/** The program over time: a line for each servo, marks for functions, motor stop and DT, to be read and to be moved. */
export function Timeline({ compact = false, ...props }: TimelineProps) {
  return compact ? <SmallTimeline {...props} /> : <WholeTimeline {...props} />;
}

/** The least width of a plot, in pixels, whatever room there is. */
const LEAST_WIDTH = 120;

function WholeTimeline({ program, overlay = null, cursor = null, selected = null, ...calls }: TimelineProps) {
  const { timeline } = messages.value;
  // While a flight is played all of this is drawn at each frame: only what has changed is made again.
  const onEdit = useStable(calls.onEdit);
  const onSelect = useStable(calls.onSelect);
  const onPoint = useStable(calls.onPoint);
  const latest = useRef(program);
  latest.current = program;
  const { now = () => latest.current } = calls;
  const selectedKey = selected && fieldKey(selected);
  const id = useId();
  const model = useMemo(() => new TimelineModel(), []);
  const keys = useMemo(() => new HandleKeys(model), []);
  const room = useRef<HTMLDivElement>(null);
  const svg = useRef<SVGSVGElement>(null);
  const width = useWidth(room);

  const behind = overlay?.program ?? null;
  const measures = measuresOf(program, false);
  const plot = Math.max(LEAST_WIDTH, width - measures.left - measures.right);
  const even = model.even.value;
  const wanted = useMemo(() => scaleOf(program, behind, even, plot), [program, behind, even, plot]);
  const scale = useGlide(wanted, model.moving.value?.scale ?? null, plot);
  const view = model.view.value;
  const geometry = useMemo(
    () => geometryOf(program, { scale, view, plot, measures, overlay: behind, selected, even }),
    [program, behind, scale, view, plot, selectedKey, even],
  );
  const front = Math.min(model.front.value, program.identity.servos - 1);

  const target = useRef<Target | null>(null);
  const pointer = useMemo(() => new PointerControl(model, () => target.current), []);
  const wantedField = model.wanted.value;
  useLayoutEffect(() => {
    target.current = svg.current && { svg: svg.current, geometry, now, onEdit };
    if (!wantedField) return;
    model.want(null);
    svg.current?.querySelector<SVGElement>(`[data-field="${fieldKey(wantedField)}"]`)?.focus({ preventScroll: true });
  });
  useEffect(() => {
    const { current } = svg;
    // Only a listener that is not passive can keep the page from scrolling.
    current?.addEventListener('wheel', pointer.wheel, { passive: false });
    current?.addEventListener('touchstart', pointer.touch, { passive: false });
    return () => {
      current?.removeEventListener('wheel', pointer.wheel);
      current?.removeEventListener('touchstart', pointer.touch);
      pointer.cancel();
      keys.up();
    };
  }, []);
  useEffect(() => {
    if (!onPoint) return;
    const stop = model.pointed.subscribe(onPoint);
    return () => {
      stop();
      onPoint(null);
    };
  }, [onPoint]);
  useEffect(() => {
    if (!selected || selected.kind === 'idleThrottle' || model.moving.peek()) return;
    if (selected.kind === 'position') model.bringToFront(selected.servo);
    model.reveal(scale.place(timeOf(program, selected)));
  }, [selectedKey]);

  const picture = useMemo(
    () => <Picture geometry={geometry} front={front} selected={selected} overlay={behind} clip={`${id}-plot`} />,
    [geometry, front, behind],
  );
  const handles = useMemo(
    () => <Handles {...{ geometry, model, keys, front, selected, now, onEdit, onSelect }} />,
    [geometry, front, onEdit, onSelect],
  );
  const { height } = measures;
  return (
    <section
      class={`timeline ${overlay?.uncertain ? 'uncertain-behind' : ''}`}
      aria-label={calls.title ?? timeline.title}
    >
      <div class="timeline-top">
        <Moment program={program} model={model} cursor={cursor} />
        <Tools model={model} />
      </div>
      <MomentLegend {...{ program, model, cursor, front }} overlay={overlay?.name ?? null} />
      <div class="timeline-room" ref={room} style={{ height: `${height}px` }}>
        {/* biome-ignore lint/a11y/useSemanticElements: a picture with handles in it is no fieldset */}
        <svg
          ref={svg}
          width={plot + measures.left + measures.right}
          height={height}
          role="group"
          tabindex={0}
          aria-label={timeline.picture}
          aria-describedby={`${id}-about`}
          class={model.moving.value ? 'moving' : ''}
          onPointerDown={pointer.down}
          onPointerMove={pointer.hover}
          onPointerLeave={pointer.leave}
          // The handle that is nearest gets the focus, not the one that lies on top.
          onMouseDown={(event) => event.preventDefault()}
          onDblClick={pointer.doubleClick}
          onKeyDown={(event) => pictureKey(event, model, geometry)}
          onFocusOut={(event) => {
            const next = event.relatedTarget as Node | null;
            model.setEntered(next !== svg.current && (svg.current?.contains(next) ?? false));
          }}
        >
          {picture}
          <MomentLine geometry={geometry} model={model} cursor={cursor} />
          {handles}
        </svg>
      </div>
      <p class="visually-hidden" id={`${id}-about`}>
        {descriptionOf(program)} {onEdit ? timeline.keysToEdit : timeline.keys}
      </p>
      <Spoken program={program} model={model} />
      <TimelineNotes program={program} />
      <div class="timeline-foot">
        <TimelineTable program={program} />
        <EvenSeconds model={model} />
      </div>
    </section>
  );
}

function MomentLine(props: { geometry: ReturnType<typeof geometryOf>; model: TimelineModel; cursor: number | null }) {
  const { geometry, model, cursor } = props;
  return <Crosshair geometry={geometry} time={model.asked.value ?? cursor} />;
}

const ALL = { start: 0, span: 1 };

function SmallTimeline({ program, overlay = null, cursor = null }: TimelineProps) {
  const id = useId();
  const room = useRef<HTMLDivElement>(null);
  const width = useWidth(room);
  const behind = overlay?.program ?? null;
  const measures = measuresOf(program, true);
  const plot = Math.max(LEAST_WIDTH, width - measures.left - measures.right);
  const geometry = useMemo(() => {
    const scale = scaleOf(program, behind, false, plot);
    return geometryOf(program, { scale, view: ALL, plot, measures, overlay: behind, selected: null, even: false });
  }, [program, behind, plot]);
  const picture = useMemo(
    () => <Picture geometry={geometry} front={null} selected={null} overlay={behind} clip={`${id}-plot`} />,
    [geometry, behind],
  );
  return (
    <div class="timeline small">
      <div class="timeline-room" ref={room} style={{ height: `${measures.height}px` }}>
        <svg
          width={plot + measures.left + measures.right}
          height={measures.height}
          role="img"
          aria-label={descriptionOf(program)}
        >
          {picture}
          <Crosshair geometry={geometry} time={cursor} />
        </svg>
      </div>
    </div>
  );
}
