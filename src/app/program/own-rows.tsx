import { useComputed } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { ProgramField } from '../../program/index.js';
import { computedList } from '../editing/computed-list.js';
import { FIRST_SERVO_COLUMN, TIME_COLUMN } from '../editing/grid.js';
import { messages, valueText } from '../messages/index.js';
import { isSameNote, notesFor } from './field-notes.js';
import { type ProgramRowProps, TimeUnit } from './program-row.js';
import { RowMenu } from './row-menu.js';
import { cellProps, RowModel } from './row-model.js';
import { RowNotes } from './row-notes.js';
import { ValueField } from './value-field.js';

const MOTOR_STOP: ProgramField = { kind: 'time', slot: 0 };
const THROTTLE: ProgramField = { kind: 'idleThrottle' };

type MotorRowProps = Omit<ProgramRowProps, 'bench' | 'follow'>;

/** The motor stop, if it comes before the row of this slot. */
export function MotorRowBefore(props: MotorRowProps) {
  const { place, slot } = props;
  const isHere = useComputed(() => place.before.value === slot).value;
  return isHere ? <MotorRow {...props} /> : null;
}

function MotorRow({ session, tools, identity, servos, selection, hand, marked, rested }: MotorRowProps) {
  const { editor } = session;
  const { program, edits } = messages.value;
  const row = useMemo(() => new RowModel({ editor, selection, marked }, 0, [MOTOR_STOP]), [editor, selection, marked]);
  const name = program.motorStop;
  const revert = { label: edits.field.putBack(name), act: () => editor.revert(MOTOR_STOP) };
  return (
    <>
      <tr class="motor-stop" data-slot="0">
        <th scope="row" data-short={program.motor}>
          <span class="row-name">{name}</span> <TimeUnit {...{ editor, identity }} slot={0} />
          <RowMenu {...{ tools, identity, name, revert }} slot={0} shifts isChanged={row.isChanged} />
        </th>
        <td {...cellProps(row, TIME_COLUMN, 'time')}>
          <ValueField {...{ editor, selection, hand }} standing={session.standing} field={MOTOR_STOP} />
        </td>
        <td class="interval" />
        <td colSpan={servos.length} />
      </tr>
      <RowNotes {...{ identity, rested }} notes={row.notes} width={servos.length + FIRST_SERVO_COLUMN + 1} />
    </>
  );
}

type ThrottleRowProps = Pick<ProgramRowProps, 'session' | 'identity' | 'servos' | 'hand' | 'rested'>;

/** The idle throttle, if the timer has told one or should have. It is no function, so it stands below them. */
export function ThrottleRow({ session, identity, servos, hand, rested }: ThrottleRowProps) {
  const { editor } = session;
  const { program } = messages.value;
  const isKnown = useComputed(() => typeof editor.working.value?.idleThrottle === 'number').value;
  const notes = useMemo(() => computedList(() => notesFor(editor, THROTTLE), isSameNote), [editor]);
  // Only a Q is known to have one. What was made here says nothing of a timer.
  if (!isKnown && (identity.timerClass !== 'Q' || editor.madeAt.value !== null)) return null;
  return (
    <>
      <tr class="throttle">
        <th scope="row" data-short={program.throttle}>
          <span class="row-name">{program.idleThrottle}</span>
        </th>
        <td class="time">
          {isKnown && <ValueField {...{ editor, hand }} standing={session.standing} field={THROTTLE} />}
        </td>
        <td class="interval" />
        <td class="aside" colSpan={servos.length}>
          {isKnown ? program.idleThrottleUnit : valueText(identity, THROTTLE, null)}
        </td>
      </tr>
      <RowNotes {...{ identity, rested, notes }} width={servos.length + FIRST_SERVO_COLUMN + 1} />
    </>
  );
}
