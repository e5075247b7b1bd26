import { type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { slotCount } from '../../protocol/index.js';
import { figureText, messages, slotLabel } from '../messages/index.js';
import { SlotHead } from '../ui/slot-head.js';
import './comparison-grid.css';

interface ComparisonGridProps {
  readonly first: TimerProgram;
  readonly second: TimerProgram;
  /** The names of the two programs. */
  readonly names: readonly [string, string];
  /** Whether the first will replace the second. */
  readonly replaces?: boolean;
}

/** Two programs in one grid. Equal values stand once, different values twice. */
export function ComparisonGrid({ first, second, names, replaces = false }: ComparisonGridProps) {
  const { write: words, program: titles } = messages.value;
  const { identity } = first;
  const servos = Array.from({ length: identity.servos }, (_, servo) => servo);
  const slots = Array.from({ length: slotCount(identity) }, (_, slot) => slot);
  // The time of the start is the motor stop on a Q, and means nothing on other classes: it is shown there only if it
  // differs.
  const hasTime = (slot: number): boolean =>
    slot > 0 || (identity.timerClass !== 'Q' && first.times[0] !== second.times[0]);
  return (
    <div class={`comparison-grid ${replaces ? 'replaces' : ''}`}>
      <table>
        <caption class="visually-hidden">{words.sideBySide(names)}</caption>
        <SlotHead
          slot={
            <>
              {names[0]} <small>{names[1]}</small>
            </>
          }
          headings={[titles.time]}
          servos={identity.servos}
        />
        <tbody>
          {identity.timerClass === 'Q' && (
            <tr class="motor-stop">
              <th scope="row">{titles.motorStop}</th>
              <Cell {...{ first, second, names }} field={{ kind: 'time', slot: 0 }} />
              <td colSpan={servos.length} />
            </tr>
          )}
          {slots.map((slot) => (
            <tr key={slot}>
              <th scope="row">{slotLabel(identity, slot)}</th>
              {hasTime(slot) ? <Cell {...{ first, second, names }} field={{ kind: 'time', slot }} /> : <td />}
              {servos.map((servo) => (
                <Cell key={servo} {...{ first, second, names }} field={{ kind: 'position', servo, slot }} />
              ))}
            </tr>
          ))}
          {typeof (first.idleThrottle ?? second.idleThrottle) === 'number' && (
            <tr>
              <th scope="row">{titles.idleThrottle}</th>
              <Cell {...{ first, second, names }} field={{ kind: 'idleThrottle' }} />
              <td colSpan={servos.length} />
            </tr>
          )}
        </tbody>
      </table>
    </div>
  );
}

interface CellProps extends ComparisonGridProps {
  readonly field: ProgramField;
}

function Cell({ first, second, names, field }: CellProps) {
  const [one, other] = [first, second].map((program) => {
    const value = valueAt(program, field);
    return value === null ? messages.value.write.status.unknown : figureText(program.identity, field, value);
  });
  if (one === other) return <td>{one}</td>;
  return (
    <td class="differs">
      <span class="visually-hidden">{names[0]} </span>
      {one} <span class="visually-hidden">{names[1]} </span>
      <small>{other}</small>
    </td>
  );
}
