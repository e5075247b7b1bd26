import { type ReadonlySignal, useComputed } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { type ProgramField, slotKind } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Bench } from '../bench/bench.js';
import type { Follow } from '../bench/follow.js';
import { ServosHere, ServosOffer } from '../bench/servos-here.js';
import type { Editor } from '../editing/editor.js';
import { FIRST_SERVO_COLUMN, INTERVAL_COLUMN, TIME_COLUMN } from '../editing/grid.js';
import { formatTime } from '../editing/units.js';
import { fieldLabel, figureOf, messages, slotLabel } from '../messages/index.js';
import type { Session } from '../work/session.js';
import type { Hand } from './hand.js';
import type { MotorPlace } from './motor-place.js';
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
  /** Where the motor stop stands. */
  readonly place: MotorPlace;
}

/** One slot of the program: its time, its interval, a position for each servo, and the notes about them. */
export function ProgramRow(props: ProgramRowProps) {
  const { session, bench, follow, tools, identity, slot, servos, selection, hand, marked, rested, place } = props;
  const { editor } = session;
  const { edits, slotShort } = messages.value;
  const isStart = slot === 0;
  // The motor stop of a Q has a row of its own. On other classes its time is reserved.
  const ownsTime = !isStart || identity.timerClass !== 'Q';
  const [positions, fields] = useMemo(() => {
    const positions = servos.map((servo): ProgramField => ({ kind: 'position', servo, slot }));
    return [positions, ownsTime ? [{ kind: 'time', slot } as const, ...positions] : positions];
  }, [servos, slot, ownsTime]);
  const row = useMemo(
    () => new RowModel({ editor, selection, marked }, slot, fields),
    [editor, selection, marked, slot, fields],
  );
  const name = slotLabel(identity, slot);
  const revert = {
    label: edits.field.putBack(name),
    act: () => editor.revertFields({ code: 'change', params: { slot } }, fields),
  };
  const cell = { editor, standing: session.standing, selection, hand };
  const width = servos.length + FIRST_SERVO_COLUMN + 1;
  return (
    <>
      <tr class={slotKind(identity, slot)} data-slot={slot}>
        <th scope="row" data-short={slotShort(slot, slotKind(identity, slot))}>
          <span class="row-name">{name}</span> {!isStart && <TimeUnit {...{ editor, identity, slot }} />}
          <ServosHere bench={bench} follow={follow} slot={slot} />
          <RowMenu {...{ tools, identity, slot, name, revert }} shifts={slot > 0} isChanged={row.isChanged} />
        </th>
        {isStart ? (
          <td class="time origin">
            {ownsTime && <ReservedTime editor={editor} />} {'0'}
          </td>
        ) : (
          <td {...cellProps(row, TIME_COLUMN, 'time')}>
            <ValueField {...cell} field={{ kind: 'time', slot }} />
          </td>
        )}
        <td {...cellProps(row, INTERVAL_COLUMN, 'interval')}>
          {slot > 0 && <CountedFrom {...{ identity, slot, place }} />}
          {slot > 0 && <ValueField {...cell} field={{ kind: 'interval', slot }} />}
        </td>
        {positions.map((field, servo) => (
          <td key={fieldLabel(identity, field)} {...cellProps(row, FIRST_SERVO_COLUMN + servo)}>
            <ValueField {...cell} field={field} />
          </td>
        ))}
      </tr>
      <RowNotes {...{ identity, rested, width }} notes={row.notes} />
      <ServosOffer bench={bench} follow={follow} identity={identity} slot={slot} width={width} />
    </>
  );
}

/**
 * Below the motor stop an interval does not count from the row above it, so it says from what: from the function
 * before, or from launch.
 */
function CountedFrom({ identity, slot, place }: Pick<ProgramRowProps, 'identity' | 'slot' | 'place'>) {
  const isBelow = useComputed(() => place.before.value === slot).value;
  if (!isBelow) return null;
  const { edits, slotShort } = messages.value;
  return <span class="cell-name">{edits.table.countedFrom(slotShort(slot - 1, slotKind(identity, slot - 1)))}</span>;
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

/** What a timer of class B or E holds in the place of the start's time. Nobody knows what it means, so it stays. */
function ReservedTime({ editor }: { readonly editor: Editor }) {
  const { program, seconds } = messages.value;
  const time = useComputed(() => editor.working.value?.times[0] ?? 0).value;
  return time === 0 ? null : <span class="row-unit">{program.reserved(seconds(formatTime(time)))}</span>;
}
