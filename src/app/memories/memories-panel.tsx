import { sameLayout } from '../../program/index.js';
import { dateText, messages, timerName } from '../messages/index.js';
import type { Session } from '../session/session.js';
import type { Backup } from '../storage/index.js';
import type { Memories } from './memories.js';
import './memories-panel.css';

/** What can be done with all memories, and the backups that are kept. */
export function MemoriesPanel({ session, memories }: { readonly session: Session; readonly memories: Memories }) {
  const { memories: words, memoryName } = messages.value;
  const baseline = session.editor.baseline.value;
  const ready = session.runner.ready.value;
  if (!baseline || baseline.memory === null) return null;
  const { memory, identity } = baseline;
  const others = Array.from({ length: identity.memories }, (_, index) => index).filter((index) => index !== memory);
  return (
    <section class="all-memories">
      <h2>{words.title}</h2>
      <div class="buttons">
        <button type="button" disabled={!ready} onClick={() => memories.jobs.open({ kind: 'back-up' })}>
          {words.backUp}
        </button>
      </div>
      <Picks
        label={words.copyTo(memoryName(memory))}
        picks={others}
        disabled={!ready}
        nameOf={(to) => words.copy(memoryName(memory), memoryName(to))}
        onPick={(to) => memories.jobs.open({ kind: 'copy', from: memory, to })}
      />
      {session.editor.dirty.value && <p class="hint">{words.edited}</p>}
    </section>
  );
}

interface BackupsPanelProps {
  readonly session: Session;
  readonly memories: Memories;
  /** The servos follow what is edited: a backup that is shown would be stored at once. */
  readonly following: boolean;
}

/** What was kept of timers, newest first; memories that were backed up together stand together. */
export function BackupsPanel({ session, memories, following }: BackupsPanelProps) {
  const { backups: words } = messages.value;
  const sets = together(session.backups.list.value);
  return (
    <section class="backups">
      <h2>{words.title}</h2>
      {sets.length === 0 ? (
        <p class="hint">{words.empty}</p>
      ) : (
        <ul>
          {sets.map((set) => (
            <BackupRow key={set[0]?.key} session={session} memories={memories} set={set} following={following} />
          ))}
        </ul>
      )}
    </section>
  );
}

interface BackupRowProps extends BackupsPanelProps {
  readonly set: readonly Backup[];
}

function BackupRow({ session, memories, set, following }: BackupRowProps) {
  const { backups: words, memories: all, memoryName, recovery } = messages.value;
  const [first] = set;
  if (!first) return null;
  const { identity, memory } = first.program;
  const working = session.editor.working.value;
  const fits = working !== null && sameLayout(working.identity, identity);
  const canShow = fits && !following;
  const isSet = first.reason === 'memories';
  const name = memory === null ? recovery.unknownMemory : memoryName(memory);
  return (
    <li class="backup">
      <p>
        <strong>{isSet ? words.set(timerName(identity), set.length) : words.entry(timerName(identity), name)}</strong>{' '}
        <span class="hint">{words.origin(dateText(first.savedAt), words.reasons[first.reason], first.simulated)}</span>
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
          <button type="button" disabled={!canShow} onClick={() => session.showBackup(first)}>
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
            if (backup) session.showBackup(backup);
          }}
        />
      )}
      {!fits && <p class="hint">{words.otherLayout}</p>}
    </li>
  );
}

interface PicksProps {
  readonly label: string;
  readonly picks: readonly number[];
  readonly disabled: boolean;
  readonly nameOf: (memory: number) => string;
  readonly onPick: (memory: number) => void;
}

/** One of several memories, in one row. */
function Picks({ label, picks, disabled, nameOf, onPick }: PicksProps) {
  const { memoryName } = messages.value;
  return (
    <div class="picks">
      <span>{label}</span>
      <div class="segments">
        {picks.map((memory) => (
          <button
            type="button"
            key={memory}
            aria-label={nameOf(memory)}
            disabled={disabled}
            onClick={() => onPick(memory)}
          >
            {memoryName(memory)}
          </button>
        ))}
      </div>
    </div>
  );
}

/** Newest first; those of one job over the memories share the time at which they were kept. */
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
