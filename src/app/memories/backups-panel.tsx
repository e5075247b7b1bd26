import { sameLayout } from '../../program/index.js';
import { dateText, messages, timerName } from '../messages/index.js';
import type { Session } from '../session/session.js';
import type { Backup } from '../storage/index.js';
import { useHandedFocus } from '../ui/use-handed-focus.js';
import type { Memories } from './memories.js';
import { Picks } from './memory-picks.js';
import './backups-panel.css';

interface BackupsPanelProps {
  readonly session: Session;
  readonly memories: Memories;
  /** Whether the servos follow edits: a loaded backup would be stored at once. */
  readonly following: boolean;
  /** Shows the table with the loaded backup. */
  readonly onLoad: () => void;
}

/** The backups of timers, newest first. Memories that were backed up together stand together. */
export function BackupsPanel({ session, ...props }: BackupsPanelProps) {
  const { backups: words } = messages.value;
  const sets = together(session.backups.list.value);
  // A deleted backup takes its button along.
  const box = useHandedFocus('h2');
  return (
    <section {...box} class="backups" aria-labelledby="backups-title">
      <h2 id="backups-title" tabIndex={-1}>
        {words.title}
      </h2>
      {sets.length === 0 ? (
        <p class="hint">{words.empty}</p>
      ) : (
        <ul>
          {sets.map((set) => (
            <BackupRow key={set[0]?.key} session={session} set={set} {...props} />
          ))}
        </ul>
      )}
    </section>
  );
}

interface BackupRowProps extends BackupsPanelProps {
  readonly set: readonly Backup[];
}

function BackupRow({ session, memories, set, following, onLoad }: BackupRowProps) {
  const { backups: words, memories: all, memoryName, recovery } = messages.value;
  const [first] = set;
  if (!first) return null;
  const { identity, memory } = first.program;
  const working = session.editor.working.value;
  const fits = working !== null && sameLayout(working.identity, identity);
  const canShow = fits && !following;
  const isSet = first.reason === 'memories';
  const load = (backup: Backup): void => {
    session.onScreen.showBackup(backup);
    onLoad();
  };
  const name = memory === null ? recovery.unknownMemory : memoryName(memory);
  return (
    <li class="backup">
      <p>
        <strong>{isSet ? words.set(timerName(identity), set.length) : words.entry(timerName(identity), name)}</strong>{' '}
        <span class="hint">
          {words.origin(dateText(first.savedAt), isSet ? null : words.reasons[first.reason], first.simulated)}
        </span>
      </p>
      <div class="buttons">
        {isSet && (
          <button
            type="button"
            disabled={!fits || !session.runner.ready.value}
            onClick={() => memories.jobs.open({ kind: 'restore', backups: [...set].reverse() })}
          >
            {all.restoreAll}
          </button>
        )}
        {!isSet && (
          <button type="button" disabled={!canShow} onClick={() => load(first)}>
            {words.show}
          </button>
        )}
        <button type="button" class="quiet" onClick={() => session.backups.remove(set)}>
          {words.remove}
        </button>
      </div>
      {isSet && (
        <Picks
          label={words.show}
          picks={set.flatMap(({ program }) => (program.memory === null ? [] : [program.memory])).reverse()}
          disabled={!canShow}
          nameOf={(picked) => words.showOf(memoryName(picked))}
          onPick={(picked) => {
            const backup = set.find(({ program }) => program.memory === picked);
            if (backup) load(backup);
          }}
        />
      )}
      {!fits && <p class="hint">{words.otherLayout}</p>}
    </li>
  );
}

/** Newest first. The backups of one job over the memories share their time. */
function together(backups: readonly Backup[]): Backup[][] {
  const sets: Backup[][] = [];
  for (const backup of backups) {
    const last = sets.at(-1);
    if (
      last?.[0] &&
      backup.reason === 'memories' &&
      last[0].reason === 'memories' &&
      last[0].savedAt === backup.savedAt
    ) {
      last.push(backup);
    } else {
      sets.push([backup]);
    }
  }
  return sets;
}
