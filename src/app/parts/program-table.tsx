import { useSignal } from '@preact/signals';
import { columnKind, fieldKey, type ProgramField } from '../../program/index.js';
import { columnCount, type Identity } from '../../protocol/index.js';
import { columnLabel, fieldLabel, messages } from '../messages/index.js';
import { useModels } from '../models.js';
import { notesFor } from './field-notes.js';
import { ValueField } from './value-field.js';

/** Start to DT as rows; time and servos as columns. Enter and the arrows move like in a spreadsheet. */
export function ProgramTable() {
  const { session } = useModels();
  const { program, servoName } = messages.value;
  const identity = session.editor.working.value?.identity;
  if (!identity) return null;
  const columns = Array.from({ length: columnCount(identity) }, (_, column) => column);
  const servos = Array.from({ length: identity.servos }, (_, servo) => servo);
  return (
    <table class="program-table" onKeyDown={moveByKey}>
      <caption class="visually-hidden">{program.tableCaption}</caption>
      <thead>
        <tr>
          <th scope="col">{program.column}</th>
          <th scope="col">{program.time}</th>
          {servos.map((servo) => (
            <th scope="col" key={servo}>
              {servoName(servo)}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {columns.map((column) => (
          <ProgramRow key={column} identity={identity} column={column} servos={servos} />
        ))}
      </tbody>
    </table>
  );
}

interface ProgramRowProps {
  readonly identity: Identity;
  readonly column: number;
  readonly servos: readonly number[];
}

function ProgramRow({ identity, column, servos }: ProgramRowProps) {
  const { session } = useModels();
  const { about } = messages.value;
  const time: ProgramField = { kind: 'time', column };
  const positions = servos.map((servo): ProgramField => ({ kind: 'position', servo, column }));
  const notes = [time, ...positions].flatMap((field) => notesFor(session.editor, field));
  return (
    <>
      <tr class={columnKind(identity, column)} data-column={column}>
        <th scope="row">{columnLabel(identity, column)}</th>
        <td class="time">
          <TimeCell identity={identity} column={column} />
        </td>
        {positions.map((field) => (
          <td key={fieldLabel(identity, field)}>
            <ValueField field={field} label={fieldLabel(identity, field)} place="table" />
          </td>
        ))}
      </tr>
      {notes.length > 0 && (
        <tr class="row-notes">
          <td colSpan={servos.length + 2}>
            {notes.map(({ field, severity, text }) => (
              <p key={`${fieldKey(field)} ${text}`} class={severity}>
                <strong>{about(fieldLabel(identity, field))}</strong> {text}
              </p>
            ))}
          </td>
        </tr>
      )}
    </>
  );
}

/** Column 0 is the motor stop on Q. On B and E it is reserved: shown, and edited only on purpose. */
function TimeCell({ identity, column }: { identity: Identity; column: number }) {
  const { program } = messages.value;
  const unlocked = useSignal(false);
  const field: ProgramField = { kind: 'time', column };
  const label = fieldLabel(identity, field);
  const isMotorStop = column === 0 && identity.timerClass === 'Q';
  const reserved = column === 0 && !isMotorStop;
  return (
    <>
      <ValueField field={field} label={label} place="table" readOnly={reserved && !unlocked.value} />
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

const STEPS: Readonly<Record<string, number>> = { Enter: 1, 'Shift+Enter': -1, ArrowDown: 1, ArrowUp: -1 };

/** Moves to the field above or below. */
function moveByKey(event: KeyboardEvent): void {
  const step = STEPS[event.shiftKey ? `Shift+${event.key}` : event.key];
  const { target } = event;
  if (step === undefined || !(target instanceof HTMLInputElement)) return;
  const cell = target.closest('td');
  const rows = [...(target.closest('tbody')?.querySelectorAll('tr[data-column]') ?? [])];
  const row = rows[rows.indexOf(target.closest('tr') as HTMLTableRowElement) + step];
  const next = row?.children[cell?.cellIndex ?? 0]?.querySelector('input');
  if (!next) return;
  event.preventDefault();
  next.focus();
}
