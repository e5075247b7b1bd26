import { type ReadonlySignal, useComputed, useSignal } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';
import { fieldKey, type ProgramField, slotKind } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Bench } from '../bench/bench.js';
import type { Follow } from '../bench/follow.js';
import { ServosHere, ServosOffer } from '../bench/servos-here.js';
import { FIRST_SERVO_COLUMN, INTERVAL_COLUMN, TIME_COLUMN } from '../editing/grid.js';
import { fieldLabel, messages, slotLabel } from '../messages/index.js';
import { programKey } from '../session/record-keys.js';
import type { Session } from '../session/session.js';
import { IntervalField } from './interval-field.js';
import { RowModel } from './row-model.js';
import type { Selection } from './selection.js';
import { ValueField } from './value-field.js';

interface ProgramRowProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
  readonly identity: Identity;
  readonly slot: number;
  readonly servos: readonly number[];
  readonly selection: Selection;
  /** The field whose handle is meant in the timeline. */
  readonly marked: ReadonlySignal<ProgramField | null>;
}

/** One slot of the program: its time, its interval and a position for each servo, and what is to be said about them. */
export function ProgramRow({ session, bench, follow, identity, slot, servos, selection, marked }: ProgramRowProps) {
  const { editor } = session;
  const { about, program, edits, servoName } = messages.value;
  const [positions, fields] = useMemo(() => {
    const positions = servos.map((servo): ProgramField => ({ kind: 'position', servo, slot }));
    return [positions, [{ kind: 'time', slot }, ...positions]] as const;
  }, [servos, slot]);
  const row = useMemo(
    () => new RowModel({ editor, selection, marked }, slot, fields),
    [editor, selection, marked, slot, fields],
  );
  const { value: notes } = row.notes;
  const { value: changed } = row.isChanged;
  const { value: markedAt } = row.markedAt;
  const [left, right] = [row.selectedFrom.value, row.selectedTo.value];
  const name = slotLabel(identity, slot);
  const cell = (at: number, label: string) => {
    const isSelected = at >= left && at <= right;
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
          <TimeCell session={session} selection={selection} identity={identity} slot={slot} />
        </td>
        <td {...cell(INTERVAL_COLUMN, edits.table.interval)}>
          {slot > 0 && <IntervalField {...{ editor, selection, slot }} label={edits.table.intervalOf(name)} />}
        </td>
        {positions.map((field, servo) => (
          <td key={fieldLabel(identity, field)} {...cell(FIRST_SERVO_COLUMN + servo, servoName(servo))}>
            <ValueField {...{ session, selection, field }} label={fieldLabel(identity, field)} place="table" />
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
  readonly selection: Selection;
  readonly identity: Identity;
  readonly slot: number;
}

/** Slot 0 is the motor stop on Q. On B and E it is reserved: shown, and edited only on purpose. */
function TimeCell({ session, selection, identity, slot }: TimeCellProps) {
  const { editor } = session;
  const { program } = messages.value;
  const unlocked = useSignal(false);
  const shown = useComputed(() =>
    editor.working.value ? programKey(editor.working.value, session.simulated.value) : null,
  ).value;
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
      <ValueField {...{ session, selection, field, label }} place="table" readOnly={reserved && !unlocked.value} />
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
