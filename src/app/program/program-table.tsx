import { Fragment } from 'preact';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { slotCount } from '../../protocol/index.js';
import { messages } from '../messages/index.js';
import { useHeight } from '../ui/use-height.js';
import { EditSheet } from './edit-sheet.js';
import { PasteDialog } from './paste-dialog.js';
import { MotorRowBefore, ProgramRow, type RowsProps, ThrottleRow } from './program-rows.js';
import { RangeBar } from './range-bar.js';
import { TableHead } from './table-head.js';
import { onTableKey } from './table-keys.js';
import { TableModel } from './table-model.js';
import { pointerListeners } from './table-pointer.js';
import './program-table.css';
import './table-box.css';

interface ProgramTableProps extends Pick<RowsProps, 'session' | 'bench' | 'follow' | 'tools'> {
  /** The field whose handle is used in the timeline. */
  readonly marked: TableModel['marked'];
}

/** With more rows or columns, the table scrolls inside itself and keeps its headings in sight. */
const MOST_SLOTS = 12;
const MOST_SERVOS = 4;

/** Rows from start to DT; columns for time, interval and servos. It works like a spreadsheet. */
export function ProgramTable({ session, bench, follow, marked, tools }: ProgramTableProps) {
  const { editor } = session;
  const { program, edits } = messages.value;
  const table = useMemo(() => new TableModel(editor, marked), [editor, marked]);
  const listeners = useMemo(() => pointerListeners(table), [table]);
  useEffect(() => table.follow(), [table]);
  const foot = useRef<HTMLDivElement>(null);
  useHeight(foot, '--range', 0);
  const identity = editor.identity.value;
  const servos = useMemo(() => Array.from({ length: identity?.servos ?? 0 }, (_, servo) => servo), [identity]);
  if (!identity) return null;
  const slots = Array.from({ length: slotCount(identity) }, (_, slot) => slot);
  const isLarge = slots.length > MOST_SLOTS || servos.length > MOST_SERVOS;
  const shared = { session, bench, follow, tools, table, identity, servos };
  const hasMotor = identity.timerClass === 'Q';
  return (
    <>
      <div
        class={`stack table-box ${isLarge ? 'large' : ''}`}
        style={{ '--rows': slots.length + (hasMotor ? 1 : 0), '--servos': servos.length }}
      >
        <div class="table-scroller">
          <table
            class={`program-table ${table.byIntervals.value ? 'by-intervals' : ''}`}
            {...listeners}
            onKeyDown={(event) => onTableKey(event, table)}
            onCopy={(event) => table.copy(event)}
            onCut={(event) => table.copy(event)}
            onPaste={(event) => table.paste(event)}
          >
            <caption class="visually-hidden">{program.tableCaption}</caption>
            <TableHead
              {...{ table, tools, identity, servos }}
              uses={session.servoUses.named.value}
              onSwitch={() => table.switchColumn()}
            />
            <tbody>
              {slots.map((slot) => (
                <Fragment key={slot}>
                  <MotorRowBefore {...shared} slot={slot} />
                  <ProgramRow {...shared} slot={slot} />
                </Fragment>
              ))}
              <MotorRowBefore {...shared} slot={slots.length} />
              <ThrottleRow {...shared} />
            </tbody>
          </table>
        </div>
        <div class="stack range-foot" ref={foot}>
          <RangeBar {...{ table, identity }} />
          {table.obstacle.value && (
            <p class="panel notes bad-text" role="alert">
              {edits.nothingDone} {table.obstacle.value}
            </p>
          )}
        </div>
        <EditSheet {...{ table, identity }} standing={session.standing} isBehind={follow.isBehind} />
      </div>
      {/* Outside: the head of the table stays in sight, that of the dialog scrolls. */}
      <PasteDialog {...{ session, table }} />
    </>
  );
}
