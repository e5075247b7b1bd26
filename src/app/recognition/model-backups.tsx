import { useSignal } from '@preact/signals';
import { differences, sameLayout } from '../../program/index.js';
import { dotted } from '../messages/dotted.js';
import { comparingMessages } from '../messages/en-compare.js';
import { dateText, dayText, messages } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { memoryOf } from '../session/memory-names.js';
import type { Session } from '../session/session.js';
import type { Backup, ModelRecord } from '../storage/index.js';
import './model-backups.css';

/** How many rows are shown at first. */
const ROOM = 8;

interface ModelBackupsProps {
  readonly session: Session;
  readonly record: ModelRecord;
  /** Whether the servos follow edits: a loaded backup would be stored at once. */
  readonly following: boolean;
  /** Shows the table with the loaded backup. */
  readonly onLoad: () => void;
  /** Compares a backup with the program on the screen or in the timer. */
  readonly onCompare: (backup: Backup) => void;
}

/** What the timer of a model held before each write, and how that differs from what it holds now. */
export function ModelBackups({ session, record, ...props }: ModelBackupsProps) {
  const { modelBackups: words } = comparingMessages;
  const own = session.backups.list.value.filter(({ model }) => model === record.key);
  const real = own.filter(({ simulated }) => !simulated);
  const simulated = own.filter((each) => each.simulated);
  return (
    <section class="model-backups" aria-labelledby="model-backups-title">
      <h3 id="model-backups-title">{words.title}</h3>
      <p class="hint">{own.length === 0 ? words.empty : words.hint}</p>
      <Rows {...{ session, record, ...props }} backups={real} />
      {simulated.length > 0 && (
        <details>
          <summary>{words.simulated(simulated.length)}</summary>
          <Rows {...{ session, record, ...props }} backups={simulated} />
        </details>
      )}
    </section>
  );
}

interface RowsProps extends ModelBackupsProps {
  readonly backups: readonly Backup[];
}

function Rows({ backups, ...props }: RowsProps) {
  const { modelBackups: words } = comparingMessages;
  const room = useSignal(ROOM);
  if (backups.length === 0) return null;
  const shown = backups.slice(0, room.value);
  return (
    <>
      <ul>
        {shown.map((backup) => (
          <Row key={backup.key} {...props} backup={backup} />
        ))}
      </ul>
      {backups.length > shown.length && (
        <button type="button" class="quiet" onClick={() => (room.value = backups.length)}>
          {words.more(backups.length - shown.length)}
        </button>
      )}
    </>
  );
}

function Row({ session, record, backup, following, onLoad, onCompare }: ModelBackupsProps & { backup: Backup }) {
  const { modelBackups: words, compare } = comparingMessages;
  const { backups: all } = messages.value;
  const { program, savedAt } = backup;
  const memory = memoryOf(record.model, program.memory);
  const name = `${memory}, ${dateText(savedAt)}`;
  const canLoad = !following && session.onScreen.canLoad(program);
  const figures = keyFigures(program).map(({ label, text }) => `${label} ${text}`);
  return (
    <li class="model-backup">
      <p>
        <strong>{memory}</strong> {dotted(figures)}{' '}
        <span class="hint">
          {dotted([dateText(savedAt), all.reasons[backup.reason], differsText(session, record, backup)])}
        </span>
      </p>
      <div class="buttons">
        <button
          type="button"
          disabled={!canLoad}
          aria-label={words.loadOf(name)}
          onClick={() => {
            session.onScreen.showBackup(backup);
            onLoad();
          }}
        >
          {words.load}
        </button>
        <button type="button" class="quiet" aria-label={words.compareOf(name)} onClick={() => onCompare(backup)}>
          {compare.open}
        </button>
      </div>
      {!canLoad && session.connection.value !== null && !following && <p class="hint">{words.cannot}</p>}
    </li>
  );
}

/** How it differs from what the timer holds now, or last held; empty when nothing is known about that. */
function differsText(session: Session, record: ModelRecord, { program, simulated }: Backup): string {
  const { modelBackups: words } = comparingMessages;
  const held = session.standings.heldBy(record, program.memory, simulated);
  if (!held || !sameLayout(held.program.identity, program.identity)) return '';
  const count = differences(held.program, program).filter(({ from, to }) => from !== null && to !== null).length;
  if (held.now) return count === 0 ? words.same : words.differs(count);
  const when = dayText(held.at);
  return count === 0 ? words.sameThen(when) : words.differsThen(count, when);
}
