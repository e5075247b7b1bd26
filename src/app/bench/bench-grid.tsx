import { messages } from '../messages/index.js';
import { dutyName } from '../messages/names.js';
import { ProgramGrid } from '../timeline/program-grid.js';
import type { Session } from '../work/session.js';
import type { Bench } from './bench.js';
import './bench-grid.css';

interface BenchGridProps {
  readonly session: Session;
  readonly bench: Bench;
}

/**
 * The values in the timer, function by function. Each row moves the servos to its function; the row where they stand is
 * lit. Where a changed position is not in the timer yet, it stands below the one to which the servo would go.
 */
export function BenchGrid({ session, bench }: BenchGridProps) {
  const { value: words } = messages;
  const { baseline, working } = session.editor;
  const program = baseline.value ?? working.value;
  const at = bench.stand.at.value;
  if (!program) return null;
  return (
    <div class="bench-table panel">
      <ProgramGrid
        program={program}
        other={working.value ?? program}
        caption={words.program.tableCaption}
        corner={words.bench.slots}
        uses={session.servoUses.named.value?.map(dutyName) ?? []}
        rows={(row) => typeof row === 'number'}
        lit={at}
        headOf={(slot, name) => (
          // Not disabled: it would lose the focus while the servos move.
          <button
            type="button"
            class="quiet"
            aria-pressed={slot === at}
            aria-disabled={!bench.ready.value}
            onClick={() => void (bench.ready.value && typeof slot === 'number' && bench.moveTo(slot))}
          >
            {name}
          </button>
        )}
      />
    </div>
  );
}
