import { useSignal } from '@preact/signals';
import { differences, sameLayout } from '../../program/index.js';
import { dotted } from '../messages/dotted.js';
import { dateText, dayText, messages } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { moreMessages } from '../messages/more.js';
import { timerName } from '../messages/names.js';
import type { Backup, ModelRecord } from '../storage/index.js';
import { useHandedFocus } from '../ui/use-handed-focus.js';
import { memoryOf } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import './backup-list.css';

/** How many backups are shown at first. */
const ROOM = 8;

interface BackupListProps {
  readonly session: Session;
  /** Shows those of one model, on its page; null shows all, and says of which model or timer each is. */
  readonly of: ModelRecord | null;
  /** Whether the servos follow edits: a loaded backup would be stored at once. */
  readonly following: boolean;
  /** Shows the program with the loaded backup. */
  readonly onLoad: () => void;
  /** Compares a backup with the program on the screen or in the timer. */
  readonly onCompare: (backup: Backup) => void;
  /** Puts memories that were backed up together back into the connected timer. Without it that is not offered. */
  readonly onRestore?: (set: readonly Backup[]) => void;
}

/** What timers held before each write, newest first, and how that differs from what they hold now. */
export function BackupList(props: BackupListProps) {
  const { session, of } = props;
  const { backups: words, showMore } = messages.value;
  const room = useSignal(ROOM);
  // A deleted backup takes its button along.
  const box = useHandedFocus('h2');
  const all = session.backups.list.value.filter(({ model }) => of === null || model === of.key);
  const shown = all.slice(0, room.value);
  return (
    <section {...box} class="stack backups" aria-labelledby="backups-title">
      <h2 id="backups-title" tabIndex={-1}>
        {words.title}
      </h2>
      {all.length === 0 ? (
        <p class="hint">{words.empty}</p>
      ) : (
        <ul class="panel ruled">
          {shown.map((backup, at) => (
            <Row key={backup.key} {...props} backup={backup} isFirst={!isOfOneJob(backup, all[at - 1])} />
          ))}
        </ul>
      )}
      {all.length > shown.length && (
        <button type="button" class="quiet" onClick={() => (room.value = all.length)}>
          {showMore({ count: all.length - shown.length })}
        </button>
      )}
    </section>
  );
}

interface RowProps extends BackupListProps {
  readonly backup: Backup;
  /** Whether it is the first of those that were backed up together. */
  readonly isFirst: boolean;
}

function Row({ session, of, backup, isFirst, following, onLoad, onCompare, onRestore }: RowProps) {
  const { backups: words, header, knowledge, open, delete: remove, of: label, notFitting } = messages.value;
  const { key, program, savedAt, reason, simulated } = backup;
  const record = of ?? session.library.models.get(backup.model ?? null) ?? null;
  const memory = memoryOf(record?.model ?? null, program.memory);
  const title = of ? memory : knowledge.memoryOf({ memory, timer: record?.model.name ?? timerName(program.identity) });
  const named = (button: string): string => label({ button, name: `${memory}, ${dateText(savedAt)}` });
  const canLoad = !following && session.onScreen.canLoad(program);
  const figures = keyFigures(program).map((figure) => `${figure.label} ${figure.text}`);
  const about = [dateText(savedAt), words.reasons[reason], simulated ? header.simulated : ''];
  return (
    <li class="row kept-row">
      <p>
        <strong>{title}</strong> {dotted(figures)}{' '}
        <span class="hint">{dotted([...about, record ? differsText(session, record, backup) : ''])}</span>
      </p>
      <div class="buttons">
        {onRestore && reason === 'memories' && isFirst && <Restore {...{ session, backup, onRestore }} />}
        <button
          type="button"
          disabled={!canLoad}
          aria-label={named(open)}
          onClick={() => {
            session.onScreen.showBackup(backup);
            onLoad();
          }}
        >
          {open}
        </button>
        <button
          type="button"
          class="quiet"
          aria-label={named(moreMessages.value.compare.open)}
          onClick={() => onCompare(backup)}
        >
          {moreMessages.value.compare.open}
        </button>
        <button type="button" class="quiet" aria-label={named(remove)} onClick={() => session.backups.remove(key)}>
          {remove}
        </button>
      </div>
      {!canLoad && session.connection.value !== null && !following && <p class="hint">{notFitting}</p>}
    </li>
  );
}

/** Puts all memories back that were backed up together. Stands at the first of them. */
function Restore({ session, backup, onRestore }: Required<Pick<RowProps, 'session' | 'backup' | 'onRestore'>>) {
  const { memories: words } = messages.value;
  const { identity } = backup.program;
  const working = session.editor.working.value;
  const fits = working !== null && sameLayout(working.identity, identity);
  const set = session.backups.list.value.filter((each) => isOfOneJob(each, backup));
  return (
    <button type="button" disabled={!fits || !session.runner.ready.value} onClick={() => onRestore([...set].reverse())}>
      {words.restoreAll({ count: set.length })}
    </button>
  );
}

/** The backups of one job over the memories share their time. */
function isOfOneJob(one: Backup, other: Backup | undefined): boolean {
  return one.reason === 'memories' && other?.reason === 'memories' && one.savedAt === other.savedAt;
}

/** How it differs from what the timer holds now, or last held; empty when nothing is known about that. */
function differsText(session: Session, record: ModelRecord, { program, simulated }: Backup): string {
  const { modelBackups: words } = moreMessages.value;
  const held = session.standings.heldBy(record, program.memory, simulated);
  if (!held || !sameLayout(held.program.identity, program.identity)) return '';
  const count = differences(held.program, program).filter(({ from, to }) => from !== null && to !== null).length;
  const when = held.now ? words.now : dayText(held.at);
  return count === 0 ? words.same({ when }) : words.differs({ count, when });
}
