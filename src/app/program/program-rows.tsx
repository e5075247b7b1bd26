import { useComputed } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { fieldKey, type ProgramField, slotKind } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Bench } from '../bench/bench.js';
import type { Follow } from '../bench/follow.js';
import { ServosHere, ServosOffer } from '../bench/servos-here.js';
import { FIRST_SERVO_COLUMN, INTERVAL_COLUMN } from '../editing/grid.js';
import { formatTime } from '../editing/units.js';
import { figureOf, messages, secondsText, slotLabel, valueText } from '../messages/index.js';
import type { Session } from '../work/session.js';
import { RowMenu } from './row-menu.js';
import { RowNotes } from './row-notes.js';
import type { RowTools } from './row-tools.js';
import type { TableModel } from './table-model.js';
import { ValueCell } from './value-cell.js';
import './program-rows.css';

const THROTTLE: ProgramField = { kind: 'idleThrottle' };

export interface RowsProps {
  readonly session: Session;
  readonly bench: Bench;
  readonly follow: Follow;
  readonly tools: RowTools;
  readonly table: TableModel;
  readonly identity: Identity;
  readonly servos: readonly number[];
}

interface SlotProps extends RowsProps {
  readonly slot: number;
}

/** One slot of the program: its time, its interval, a position for each servo, and the notes about them. */
export function ProgramRow(props: SlotProps) {
  const { session, bench, follow, table, identity, slot, servos } = props;
  const cell = { table, standing: session.standing };
  const isStart = slot === 0;
  // The motor stop of a Q has a row of its own. On other classes its time is reserved.
  const ownsTime = !isStart || identity.timerClass !== 'Q';
  const time: ProgramField = { kind: 'time', slot };
  const positions = servos.map((servo): ProgramField => ({ kind: 'position', servo, slot }));
  const kind = slotKind(identity, slot);
  return (
    <>
      <Row
        {...props}
        {...{ kind, slot }}
        name={slotLabel(identity, slot)}
        short={messages.value.slotShort({ slot, kind })}
        fields={ownsTime ? [time, ...positions] : positions}
        shifts={!isStart}
        sign={<ServosHere bench={bench} follow={follow} slot={slot} />}
      >
        {isStart ? (
          <td class="time origin">
            {ownsTime && <ReservedTime table={table} />} {'0'}
          </td>
        ) : (
          <ValueCell {...cell} field={time} />
        )}
        {isStart ? (
          <td class="interval" data-cell={INTERVAL_COLUMN} />
        ) : (
          <ValueCell {...cell} field={{ kind: 'interval', slot }}>
            <CountedFrom {...{ identity, slot, table }} />
          </ValueCell>
        )}
        {positions.map((field) => (
          <ValueCell key={fieldKey(field)} {...cell} field={field} />
        ))}
      </Row>
      <ServosOffer {...{ bench, follow, identity, slot }} width={servos.length + FIRST_SERVO_COLUMN + 1} />
    </>
  );
}

/** The motor stop, if it comes before the row of this slot. */
export function MotorRowBefore({ slot, ...props }: SlotProps) {
  const { session, table, servos } = props;
  const { program } = messages.value;
  const isHere = useComputed(() => table.motorBefore.value === slot).value;
  if (!isHere) return null;
  const field: ProgramField = { kind: 'time', slot: 0 };
  return (
    <Row {...props} kind="motor-stop" slot={0} name={program.motorStop} short={program.motor} fields={[field]} shifts>
      <ValueCell table={table} standing={session.standing} field={field} />
      <td class="interval" />
      <td colSpan={servos.length} />
    </Row>
  );
}

/** The idle throttle, if the timer has told one or should have. It is no function, so it stands below them. */
export function ThrottleRow(props: RowsProps) {
  const { session, table, identity, servos } = props;
  const { program } = messages.value;
  const throttle = useComputed(() => table.editor.working.value?.idleThrottle ?? null).value;
  const isKnown = throttle !== null;
  // It is not written into a memory that does not fly next: it may belong to all of them.
  const canEdit = isKnown && !session.onScreen.apart.value;
  // Only a Q is known to have one. What was made here says nothing of a timer.
  if (!isKnown && (identity.timerClass !== 'Q' || table.editor.madeAt.value !== null)) return null;
  return (
    <Row
      {...props}
      kind="throttle"
      slot={null}
      name={program.idleThrottle}
      short={program.throttle}
      fields={[THROTTLE]}
    >
      {canEdit ? <ValueCell table={table} standing={session.standing} field={THROTTLE} /> : <td class="time" />}
      <td class="interval" />
      <td class="aside" colSpan={servos.length}>
        {canEdit || valueText(identity, THROTTLE, throttle)} {isKnown && program.idleThrottleUnit}
      </td>
    </Row>
  );
}

interface RowProps extends RowsProps {
  readonly kind: string;
  /** Null for a row that is no part of the grid, and has no menu. */
  readonly slot: number | null;
  readonly name: string;
  readonly short: string;
  /** The values that its notes are about, and that its menu puts back. */
  readonly fields: readonly ProgramField[];
  /** Whether its time, and all later ones, can be shifted. */
  readonly shifts?: boolean;
  readonly sign?: ComponentChildren;
  readonly children: ComponentChildren;
}

/** A row with its name, and below it the notes about its fields. */
function Row(props: RowProps) {
  const { table, tools, identity, servos, kind, slot, name, short, fields, shifts = false, sign, children } = props;
  return (
    <>
      <tr class={kind} data-slot={slot ?? undefined}>
        <th scope="row" data-short={short}>
          <span class="row-name">{name}</span> {shifts && <TimeUnit {...{ table, identity }} slot={slot ?? 0} />}
          {sign}
          {slot !== null && <RowMenu {...{ tools, identity, slot, name, fields, shifts }} />}
        </th>
        {children}
      </tr>
      <RowNotes {...{ table, identity, fields }} width={servos.length + FIRST_SERVO_COLUMN + 1} />
    </>
  );
}

/**
 * Below the motor stop an interval does not count from the row above it, so it says from what: from the function
 * before, or from launch.
 */
function CountedFrom({ identity, slot, table }: Pick<SlotProps, 'identity' | 'slot' | 'table'>) {
  const isBelow = useComputed(() => table.motorBefore.value === slot).value;
  if (!isBelow) return null;
  const { edits, slotShort } = messages.value;
  return (
    <span class="cell-name">
      {edits.table.countedFrom({ row: slotShort({ slot: slot - 1, kind: slotKind(identity, slot - 1) }) })}
    </span>
  );
}

/** At a time in minutes: the heading of the column says seconds. Screen readers hear it at the field. */
function TimeUnit({ table, identity, slot }: Pick<SlotProps, 'identity' | 'slot' | 'table'>) {
  const unit = useComputed(() => {
    const time = table.editor.working.value?.times[slot];
    return time === undefined ? null : figureOf(identity, { kind: 'time', slot }, time).unit;
  }).value;
  return unit === 'min' ? (
    <small class="row-unit" aria-hidden="true">
      {messages.value.times.units[unit]}
    </small>
  ) : null;
}

/** What a timer of class B or E holds in the place of the start's time. Nobody knows what it means, so it stays. */
function ReservedTime({ table }: Pick<RowsProps, 'table'>) {
  const { program } = messages.value;
  const time = useComputed(() => table.editor.working.value?.times[0] ?? 0).value;
  return time === 0 ? null : (
    <small class="row-unit">{program.reserved({ time: secondsText(formatTime(time)) })}</small>
  );
}
