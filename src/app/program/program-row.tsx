import { type ReadonlySignal, useComputed, useSignal } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';
import { type ProgramField, slotKind } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Bench } from '../bench/bench.js';
import type { Follow } from '../bench/follow.js';
import { ServosHere, ServosOffer } from '../bench/servos-here.js';
import type { Editor } from '../editing/editor.js';
import { FIRST_SERVO_COLUMN, INTERVAL_COLUMN, TIME_COLUMN } from '../editing/grid.js';
import { fieldLabel, figureOf, messages, slotLabel } from '../messages/index.js';
import { programKey } from '../session/record-keys.js';
import type { Session } from '../session/session.js';
import type { Hand } from './hand.js';
import { IntervalField } from './interval-field.js';
import { RowMenu } from './row-menu.js';
import { cellProps, RowModel, type RowSources } from './row-model.js';
import { RowNotes } from './row-notes.js';
import type { RowTools } from './row-tools.js';
import { ValueField } from './value-field.js';
import './program-row.css';

export interface ProgramRowProps extends Pick<RowSources, 'selection' | 'marked'> {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
  readonly tools: RowTools;
  readonly identity: Identity;
  readonly slot: number;
  readonly servos: readonly number[];
  readonly hand: Hand;
  /** Changes when the pilot's hands rest. */
  readonly rested: ReadonlySignal<unknown>;
}

/** One slot of the program: its time, its interval, a position for each servo, and the notes about them. */
export function ProgramRow(props: ProgramRowProps) {
  const { session, bench, follow, tools, identity, slot, servos, selection, hand, marked, rested } = props;
  const { editor } = session;
  const { edits, slotShort } = messages.value;
  // The motor stop of a Q has a row of its own.
  const hasTime = slot > 0 || identity.timerClass !== 'Q';
  const [positions, fields] = useMemo(() => {
    const positions = servos.map((servo): ProgramField => ({ kind: 'position', servo, slot }));
    return [positions, hasTime ? [{ kind: 'time', slot } as const, ...positions] : positions];
  }, [servos, slot, hasTime]);
  const row = useMemo(
    () => new RowModel({ editor, selection, marked }, slot, fields),
    [editor, selection, marked, slot, fields],
  );
  const name = slotLabel(identity, slot);
  const revert = {
    label: edits.table.revertRow(name),
    act: () => editor.revertFields({ code: 'change', params: { slot } }, fields),
  };
  const width = servos.length + FIRST_SERVO_COLUMN + 1;
  return (
    <>
      <tr class={slotKind(identity, slot)} data-slot={slot}>
        <th scope="row" data-short={slotShort(slot, slotKind(identity, slot))}>
          <span class="row-name">{name}</span> {hasTime && <TimeUnit {...{ editor, identity, slot }} />}
          <ServosHere bench={bench} follow={follow} slot={slot} />
          <RowMenu {...{ tools, identity, slot, name, revert }} shifts={slot > 0} isChanged={row.isChanged} />
        </th>
        {hasTime ? (
          <td {...cellProps(row, TIME_COLUMN, 'time')}>
            <TimeCell {...{ session, selection, hand, identity, slot }} />
          </td>
        ) : (
          <td class="time origin">{messages.value.program.origin}</td>
        )}
        <td {...cellProps(row, INTERVAL_COLUMN, 'interval')}>
          {slot > 0 && <IntervalField {...{ editor, selection, hand, slot }} label={edits.table.intervalOf(name)} />}
        </td>
        {positions.map((field, servo) => (
          <td key={fieldLabel(identity, field)} {...cellProps(row, FIRST_SERVO_COLUMN + servo)}>
            <ValueField {...{ session, selection, hand, field }} label={fieldLabel(identity, field)} place="table" />
          </td>
        ))}
      </tr>
      <RowNotes {...{ identity, rested, width }} notes={row.notes} />
      <ServosOffer bench={bench} follow={follow} identity={identity} slot={slot} width={width} />
    </>
  );
}

interface TimeUnitProps extends Pick<ProgramRowProps, 'identity' | 'slot'> {
  readonly editor: Editor;
}

/** At a time in minutes: the heading of the column says seconds. Screen readers hear it at the field. */
export function TimeUnit({ editor, identity, slot }: TimeUnitProps) {
  const unit = useComputed(() => {
    const time = editor.working.value?.times[slot];
    return time === undefined ? null : figureOf(identity, { kind: 'time', slot }, time).unit;
  }).value;
  return unit === 'min' ? (
    <span class="row-unit" aria-hidden="true">
      {messages.value.times.units[unit]}
    </span>
  ) : null;
}

interface TimeCellProps extends Pick<ProgramRowProps, 'session' | 'selection' | 'hand' | 'identity' | 'slot'> {}

/** The time of slot 0 is reserved on B and E: it is shown, and edited only on purpose. */
function TimeCell({ session, selection, hand, identity, slot }: TimeCellProps) {
  const { editor } = session;
  const { program } = messages.value;
  const unlocked = useSignal(false);
  const shown = useComputed(() =>
    editor.working.value ? programKey(editor.working.value, session.simulated.value) : null,
  ).value;
  // The wish to edit it belongs to the program that was on the screen then.
  useEffect(() => {
    unlocked.value = false;
  }, [unlocked, shown]);
  const field: ProgramField = { kind: 'time', slot };
  const label = fieldLabel(identity, field);
  const reserved = slot === 0;
  return (
    <>
      <ValueField
        {...{ session, selection, hand, field, label }}
        place="table"
        readOnly={reserved && !unlocked.value}
      />
      {reserved && unlocked.value && <span class="cell-name">{program.reserved}</span>}
      {reserved && !unlocked.value && (
        <button
          type="button"
          class="cell-name"
          aria-label={program.editReserved}
          onClick={(event) => {
            unlocked.value = true;
            const input = event.currentTarget.closest('td')?.querySelector('input');
            if (!input) return;
            // It gets the focus before the next drawing.
            input.readOnly = false;
            input.focus();
          }}
        >
          {program.reserved}
        </button>
      )}
    </>
  );
}
