import type { ComponentChildren } from 'preact';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import type { Backup } from '../storage/index.js';
import type { Session } from '../work/session.js';
import { BackupList } from '../write/backup-list.js';
import type { WriteJob } from '../write/write-job.js';
import type { Memories } from './memories.js';
import { MemoryCards } from './memory-cards.js';

export interface MemoriesPageProps {
  readonly session: Session;
  readonly memories: Memories;
  readonly write: WriteJob;
  /** Whether the servos follow edits: a loaded backup would be stored at once. */
  readonly following: boolean;
  /** Shows the program: of the memory that was picked last, or with what was loaded into it. */
  readonly onProgram: () => void;
  /** Shows two memories side by side, by their last readings. */
  readonly onCompare: (first: number, second: number) => void;
  /** Shows a backup beside the program on the screen. */
  readonly onCompareBackup: (backup: Backup) => void;
  /** The button that connects a timer. */
  readonly connect: ComponentChildren;
  /** The button that prints the memories. */
  readonly print: ComponentChildren;
}

/** All memories of the timer at a glance, and the backups. */
export function MemoriesPage(props: MemoriesPageProps) {
  const { session, memories, write, following, onProgram, onCompare, onCompareBackup, connect, print } = props;
  const { views } = messages.value;
  const { overview: words } = moreMessages.value;
  const baseline = session.editor.baseline.value;
  return (
    <div class="stack gap-4">
      <div class="row between">
        <h1>{views.names.memories}</h1>
        {baseline && baseline.memory !== null && (
          <div class="buttons">
            {print}
            <button type="button" disabled={!session.runner.ready.value} onClick={() => void memories.backUp()}>
              {words.readAll}
            </button>
          </div>
        )}
      </div>
      {baseline ? (
        <MemoryCards {...{ session, memories, write, onProgram, onCompare }} />
      ) : (
        <>
          <p class="hint">{views.noTimer.memories}</p>
          <div>{connect}</div>
        </>
      )}
      {baseline && session.editor.dirty.value && <p class="hint">{words.edited}</p>}
      <BackupList
        session={session}
        of={null}
        following={following}
        onLoad={onProgram}
        onCompare={onCompareBackup}
        onRestore={(backups) => void write.open({ kind: 'restore', backups })}
      />
    </div>
  );
}
