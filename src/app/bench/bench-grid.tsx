import { type ProgramField, valueAt } from '../../program/index.js';
import { slotCount } from '../../protocol/index.js';
import { figureText, messages, slotLabel } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { Icon } from '../ui/icon.js';
import { SlotHead } from '../ui/slot-head.js';
import type { Bench } from './bench.js';
import './bench-grid.css';

interface BenchGridProps {
  readonly session: Session;
  readonly bench: Bench;
}

/**
 * The values in the timer, function by function. Each row moves the servos to its function; the row where they stand is
 * lit. Where a changed position is not in the timer yet, it stands after the one to which the servo would go.
 */
export function BenchGrid({ session, bench }: BenchGridProps) {
  const { bench: words, program: names } = messages.value;
  const { baseline, working } = session.editor;
  const program = baseline.value ?? working.value;
  const at = bench.stand.at.value;
  if (!program) return null;
  const { identity } = program;
  const servos = Array.from({ length: identity.servos }, (_, servo) => servo);
  return (
    <>
      <Steps bench={bench} count={slotCount(identity)} />
      <div class="bench-table">
        <table>
          <caption class="visually-hidden">{names.tableCaption}</caption>
          <SlotHead slot={words.slots} headings={[names.time]} servos={identity.servos} />
          <tbody>
            {Array.from({ length: slotCount(identity) }, (_, slot) => (
              <tr key={slotLabel(identity, slot)} class={slot === at ? 'here' : ''}>
                <th scope="row">
                  {/* Not disabled: it would lose the focus while the servos move. */}
                  <button
                    type="button"
                    aria-pressed={slot === at}
                    aria-disabled={!bench.ready.value}
                    onClick={() => void (bench.ready.value && bench.moveTo(slot))}
                  >
                    {slotLabel(identity, slot)}
                  </button>
                </th>
                <td>{slot === 0 ? '' : figureText(identity, { kind: 'time', slot }, program.times[slot] ?? 0)}</td>
                {servos.map((servo) => (
                  <Position key={servo} session={session} field={{ kind: 'position', servo, slot }} />
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </>
  );
}

/** The position in the timer, and the new one that is not there yet. */
function Position({ session, field }: { readonly session: Session; readonly field: ProgramField }) {
  const { baseline, working } = session.editor;
  const program = baseline.value ?? working.value;
  const held = program && valueAt(program, field);
  const wanted = working.value && valueAt(working.value, field);
  if (held === wanted) return <td>{held}</td>;
  return <td class="pending">{`${held} → ${wanted}`}</td>;
}

/** Buttons to the previous and the next function. */
function Steps({ bench, count }: { readonly bench: Bench; readonly count: number }) {
  const { previous, next } = messages.value;
  const ready = bench.ready.value;
  const action = bench.done.value?.action;
  const last = bench.stand.at.value ?? (action?.kind === 'move' ? action.slot : null);
  return (
    <div class="bench-steps">
      {[
        { name: previous, to: last === null ? null : last - 1, path: 'M12 4L6 10L12 16' },
        { name: next, to: last === null ? 0 : last + 1, path: 'M8 4L14 10L8 16' },
      ].map(({ name, to, path }) => {
        const can = ready && to !== null && to >= 0 && to < count;
        return (
          // Not disabled: it would lose the focus while the servos move.
          <button type="button" key={name} aria-disabled={!can} onClick={can ? () => void bench.moveTo(to) : undefined}>
            <Icon path={path} />
            <span>{name}</span>
          </button>
        );
      })}
    </div>
  );
}
