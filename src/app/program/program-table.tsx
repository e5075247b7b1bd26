import { useSignal } from '@preact/signals';
import { Fragment } from 'preact';
import { useMemo, useRef } from 'preact/hooks';
import { slotCount } from '../../protocol/index.js';
import { fillDown, stepRange } from '../editing/edits.js';
import { messages, obstacleText } from '../messages/index.js';
import { useHeight } from '../ui/use-height.js';
import { EditSheet, useHand } from './edit-sheet.js';
import { MotorPlace } from './motor-place.js';
import { MotorRowBefore, ThrottleRow } from './own-rows.js';
import { PasteDialog, type Pasting } from './paste-dialog.js';
import { ProgramRow, type ProgramRowProps } from './program-row.js';
import { RangeBar } from './range-bar.js';
import type { RowTools } from './row-tools.js';
import { useSelectRange } from './select-range.js';
import { Selection } from './selection.js';
import { cellAt } from './table-cells.js';
import { tableClipboard } from './table-clipboard.js';
import { TableHead } from './table-head.js';
import { useRested } from './use-rested.js';
import './program-table.css';
import './table-box.css';

interface ProgramTableProps extends Pick<ProgramRowProps, 'session' | 'bench' | 'follow' | 'marked'> {
  /** The tools of the rows. */
  readonly tools: RowTools;
  /** Explains the values. */
}

/** With more rows or columns, the table scrolls inside itself and keeps its headings in sight. */
const MOST_SLOTS = 12;
const MOST_SERVOS = 4;

/** Rows from start to DT; columns for time, interval and servos. It works like a spreadsheet. */
export function ProgramTable({ session, bench, follow, marked, tools }: ProgramTableProps) {
  const { editor } = session;
  const { program, edits } = messages.value;
  const selection = useMemo(() => new Selection(), []);
  const hand = useHand();
  const rested = useRested(editor);
  const place = useMemo(() => new MotorPlace(editor), [editor]);
  const pasting = useSignal<Pasting | null>(null);
  const obstacle = useSignal<string | null>(null);
  /** Whether intervals are shown in place of times, where there is no room for both. */
  const intervals = useSignal(false);
  const table = useRef<HTMLTableElement>(null);
  const foot = useRef<HTMLDivElement>(null);
  useHeight(foot, '--range', 0);
  const identity = editor.identity.value;
  const servos = useMemo(() => Array.from({ length: identity?.servos ?? 0 }, (_, servo) => servo), [identity]);

  const say = (text: string | null): void => {
    obstacle.value = text;
  };
  /** A single cell takes the value of the cell above it. */
  const fill = (): void => {
    const { working } = editor;
    const range = selection.range.value;
    if (!identity || !range || !working.value) return;
    const from = range.top === range.bottom ? { ...range, top: range.top - 1 } : range;
    if (from.top < 0) return;
    const found = editor.apply(fillDown(working.value, from, { unreadable: editor.unreadable.value }));
    say(found && obstacleText(identity, found));
  };
  selection.stepAll = (direction, options) => {
    const { working, unreadable } = editor;
    const range = selection.range.value;
    if (!identity || !range || !working.value) return;
    const found = editor.apply(
      stepRange(working.value, range, direction, { ...options, unreadable: unreadable.value }),
    );
    say(found && obstacleText(identity, found));
  };
  const { selectedText, copy, cut, paste, pasteCopied } = tableClipboard({
    editor,
    selection,
    onPaste: (text) => {
      pasting.value = text;
    },
    onObstacle: say,
  });
  const listeners = useSelectRange({
    editor,
    selection,
    fillDown: fill,
    toBar: () => foot.current?.querySelector('button')?.focus(),
    onFocus: (cell) => {
      say(null);
      if (cell) place.hold();
      else place.keep();
    },
  });
  /** With the keyboard, the focus goes back to the cell. A thumb does not want the screen keyboard. */
  const done = (): void => {
    const { value: cell } = selection.active;
    const byKeys = foot.current?.contains(document.activeElement);
    selection.collapse();
    say(null);
    if (byKeys && cell && table.current) cellAt(table.current, cell)?.querySelector('input')?.focus();
  };
  if (!identity) return null;
  const slots = Array.from({ length: slotCount(identity) }, (_, slot) => slot);
  const isLarge = slots.length > MOST_SLOTS || servos.length > MOST_SERVOS;
  const shared = { session, tools, identity, servos, selection, hand, marked, rested, place };
  const hasMotor = identity.timerClass === 'Q';
  const classes = ['program-table', selection.picking.value && 'picking', intervals.value && 'by-intervals'];
  return (
    <>
      <div
        class={`table-box ${isLarge ? 'large' : ''}`}
        style={{ '--rows': slots.length + (hasMotor ? 1 : 0), '--servos': servos.length }}
      >
        <div class="table-scroller">
          <table
            ref={table}
            class={classes.filter(Boolean).join(' ')}
            {...listeners}
            onFocusOut={({ target, relatedTarget, currentTarget }) => {
              const stays = relatedTarget instanceof Node && currentTarget.contains(relatedTarget);
              // A window that was left comes back with its focus.
              if (!stays && target !== document.activeElement) place.release();
            }}
            onCopy={copy}
            onCut={cut}
            onPaste={paste}
          >
            <caption class="visually-hidden">{program.tableCaption}</caption>
            <TableHead
              servos={servos}
              onSwitch={() => {
                intervals.value = !intervals.value;
              }}
            />
            <tbody>
              {slots.map((slot) => (
                <Fragment key={slot}>
                  <MotorRowBefore {...shared} slot={slot} />
                  <ProgramRow {...shared} {...{ bench, follow, slot }} />
                </Fragment>
              ))}
              <MotorRowBefore {...shared} slot={slots.length} />
              <ThrottleRow {...{ session, identity, servos, hand, rested }} />
            </tbody>
          </table>
        </div>
        <div class="stack range-foot" ref={foot}>
          <RangeBar
            {...{ identity, selection }}
            text={selectedText}
            onPaste={() => void pasteCopied()}
            onFill={fill}
            onDone={done}
          />
          {obstacle.value && (
            <p class="notes bad-text" role="alert">
              {edits.nothingDone} {obstacle.value}
            </p>
          )}
        </div>
        <EditSheet {...{ identity, hand }} standing={session.standing} />
      </div>
      {/* Outside: the head of the table stays in sight, that of the dialog scrolls. */}
      <PasteDialog
        session={session}
        pasting={pasting}
        onClose={() => {
          pasting.value = null;
        }}
      />
    </>
  );
}
