import { type ReadonlySignal, useSignal } from '@preact/signals';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { fieldKey, type ProgramField, slotKind } from '../../program/index.js';
import { type Identity, slotCount } from '../../protocol/index.js';
import type { Bench } from '../bench/bench.js';
import type { Follow } from '../bench/follow.js';
import { ServosHere, ServosOffer } from '../bench/servos-here.js';
import { fillDown } from '../editing/edits.js';
import { cellFor, FIRST_SERVO_COLUMN, INTERVAL_COLUMN, TIME_COLUMN } from '../editing/grid.js';
import { fieldLabel, messages, obstacleText, slotLabel } from '../messages/index.js';
import { programKey } from '../session/record-keys.js';
import type { Session } from '../session/session.js';
import { useHeight } from '../ui/use-height.js';
import { useSteady } from '../ui/use-steady.js';
import { ColumnMenu } from './column-menu.js';
import { notesFor } from './field-notes.js';
import { TableSelection } from './field-tools.js';
import { IntervalField } from './interval-field.js';
import { PasteDialog, type Pasting } from './paste-dialog.js';
import { RangeBar } from './range-bar.js';
import { useSelectRange } from './select-range.js';
import { Selection } from './selection.js';
import { cellAt } from './table-cells.js';
import { tableClipboard } from './table-clipboard.js';
import { ValueField } from './value-field.js';
import './program-table.css';

interface ProgramTableProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
  /** The field whose handle is meant in the timeline: a signal, so that only its row is drawn anew. */
  readonly marked: ReadonlySignal<ProgramField | null>;
}

/** Start to DT as rows; time, interval and servos as columns. It is worked with like a spreadsheet. */
export function ProgramTable({ session, bench, follow, marked }: ProgramTableProps) {
  const { editor } = session;
  const { program, edits, servoName } = messages.value;
  const selection = useMemo(() => new Selection(), []);
  const pasting = useSignal<Pasting | null>(null);
  const obstacle = useSignal<string | null>(null);
  const table = useRef<HTMLTableElement>(null);
  const foot = useRef<HTMLDivElement>(null);
  useHeight(foot, '--range');
  const identity = editor.identity.value;
  const servos = useMemo(() => Array.from({ length: identity?.servos ?? 0 }, (_, servo) => servo), [identity]);

  const say = (text: string | null): void => {
    obstacle.value = text;
  };
  /** A single cell is filled from the one above it. */
  const fill = (): void => {
    const { working } = editor;
    const range = selection.range.value;
    if (!identity || !range || !working.value) return;
    const from = range.top === range.bottom ? { ...range, top: range.top - 1 } : range;
    if (from.top < 0) return;
    const found = editor.apply(fillDown(working.value, from, { unreadable: editor.unreadable.value }));
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
    onFocus: () => say(null),
  });
  /** Whoever came to the buttons by keys goes back to the cell; a thumb does not want its keyboard. */
  const done = (): void => {
    const { value: cell } = selection.active;
    const byKeys = foot.current?.contains(document.activeElement);
    selection.collapse();
    say(null);
    if (byKeys && cell && table.current) cellAt(table.current, cell)?.querySelector('input')?.focus();
  };
  if (!identity) return null;
  const slots = Array.from({ length: slotCount(identity) }, (_, slot) => slot);
  return (
    <div class="table-box">
      <table
        ref={table}
        class={selection.picking.value ? 'program-table picking' : 'program-table'}
        aria-describedby="table-keys"
        {...listeners}
        onCopy={copy}
        onCut={cut}
        onPaste={paste}
      >
        <caption class="visually-hidden">{program.tableCaption}</caption>
        <thead>
          <tr>
            <th scope="col">{program.slot}</th>
            <th scope="col">{program.time}</th>
            <th scope="col">{edits.table.interval}</th>
            {servos.map((servo) => (
              <th scope="col" key={servo} aria-label={servoName(servo)}>
                {servoName(servo)}
                <ColumnMenu editor={editor} identity={identity} servo={servo} />
              </th>
            ))}
          </tr>
        </thead>
        <TableSelection.Provider value={selection}>
          <tbody>
            {slots.map((slot) => (
              <ProgramRow key={slot} {...{ session, bench, follow, identity, slot, servos, selection, marked }} />
            ))}
          </tbody>
        </TableSelection.Provider>
      </table>
      <p class="hint keys-hint" id="table-keys">
        {edits.table.keys}
      </p>
      <div class="range-foot" ref={foot}>
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
      <PasteDialog
        session={session}
        pasting={pasting}
        onClose={() => {
          pasting.value = null;
        }}
      />
    </div>
  );
}

interface ProgramRowProps extends ProgramTableProps {
  readonly identity: Identity;
  readonly slot: number;
  readonly servos: readonly number[];
  readonly selection: Selection;
}

function ProgramRow({ session, bench, follow, identity, slot, servos, selection, marked }: ProgramRowProps) {
  const { editor } = session;
  const { about, program, edits, servoName } = messages.value;
  const positions = useMemo(
    () => servos.map((servo): ProgramField => ({ kind: 'position', servo, slot })),
    [servos, slot],
  );
  const fields: ProgramField[] = [{ kind: 'time', slot }, ...positions];
  const { notes, changed } = useSteady(() => {
    const keys = fields.map(fieldKey);
    return {
      notes: fields.flatMap((field) => notesFor(editor, field)),
      changed: keys.some((key) => editor.changed.value.has(key) || editor.unreadable.value.has(key)),
    };
  }, [editor, positions]);
  const selected = useSteady(() => {
    const range = selection.shown.value;
    return range && slot >= range.top && slot <= range.bottom ? range : null;
  }, [selection, slot]);
  const markedAt = useSteady(() => {
    const place = marked.value && cellFor(marked.value);
    return place?.row === slot ? place.column : null;
  }, [marked, slot]);
  const name = slotLabel(identity, slot);
  const cell = (at: number, label: string) => {
    const isSelected = selected && at >= selected.left && at <= selected.right;
    const classes = `${isSelected ? 'selected' : ''} ${at === markedAt ? 'marked' : ''}`;
    return { 'data-cell': at, 'data-name': label, class: classes.trim() };
  };
  const timeCell = cell(TIME_COLUMN, program.time);
  return (
    <>
      <tr class={slotKind(identity, slot)} data-slot={slot}>
        <th scope="row">
          {name}
          <ServosHere bench={bench} follow={follow} slot={slot} />
          {changed && (
            <button
              type="button"
              class="put-back"
              tabIndex={-1}
              title={edits.table.revertRow(name)}
              aria-label={edits.table.revertRow(name)}
              onClick={() => editor.revertFields({ code: 'revert-row', params: { slot } }, fields)}
            />
          )}
        </th>
        <td {...timeCell} class={`time ${timeCell.class}`}>
          <TimeCell session={session} identity={identity} slot={slot} />
        </td>
        <td {...cell(INTERVAL_COLUMN, edits.table.interval)}>
          {slot > 0 && <IntervalField editor={editor} slot={slot} label={edits.table.intervalOf(name)} />}
        </td>
        {positions.map((field, servo) => (
          <td key={fieldLabel(identity, field)} {...cell(FIRST_SERVO_COLUMN + servo, servoName(servo))}>
            <ValueField session={session} field={field} label={fieldLabel(identity, field)} place="table" />
          </td>
        ))}
      </tr>
      {notes.length > 0 && (
        <tr class="row-notes">
          <td colSpan={servos.length + 3}>
            {notes.map(({ field, severity, text }) => (
              <p key={`${fieldKey(field)} ${text}`} class={severity}>
                <strong>{about(fieldLabel(identity, field))}</strong> {text}
              </p>
            ))}
          </td>
        </tr>
      )}
      <ServosOffer bench={bench} follow={follow} identity={identity} slot={slot} width={servos.length + 3} />
    </>
  );
}

interface TimeCellProps {
  readonly session: Session;
  readonly identity: Identity;
  readonly slot: number;
}

/** Slot 0 is the motor stop on Q. On B and E it is reserved: shown, and edited only on purpose. */
function TimeCell({ session, identity, slot }: TimeCellProps) {
  const { editor } = session;
  const { program } = messages.value;
  const unlocked = useSignal(false);
  const shown = useSteady(
    () => editor.working.value && programKey(editor.working.value, session.simulated.value),
    [editor, session],
  );
  // It was asked for in the program that was on the screen then.
  useEffect(() => {
    unlocked.value = false;
  }, [unlocked, shown]);
  const field: ProgramField = { kind: 'time', slot };
  const label = fieldLabel(identity, field);
  const isMotorStop = slot === 0 && identity.timerClass === 'Q';
  const reserved = slot === 0 && !isMotorStop;
  return (
    <>
      <ValueField session={session} field={field} label={label} place="table" readOnly={reserved && !unlocked.value} />
      {isMotorStop && <span class="cell-name">{program.motorStop}</span>}
      {reserved && unlocked.value && <span class="cell-name">{program.reserved}</span>}
      {reserved && !unlocked.value && (
        <button
          type="button"
          class="cell-name"
          aria-label={program.editReserved}
          onClick={(event) => {
            unlocked.value = true;
            event.currentTarget.closest('td')?.querySelector('input')?.focus();
          }}
        >
          {program.reserved}
        </button>
      )}
    </>
  );
}
