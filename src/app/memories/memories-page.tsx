import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { BackupsPanel } from './backups-panel.js';
import type { Memories } from './memories.js';
import { MemoryCards } from './memory-cards.js';
import { MemoryComparison } from './memory-comparison.js';
import './memories-page.css';

export interface MemoriesPageProps {
  readonly session: Session;
  readonly memories: Memories;
  /** Whether the servos follow edits: a loaded backup would be stored at once. */
  readonly following: boolean;
  /** Shows the program: of the memory that was picked last, or with what was loaded into it. */
  readonly onProgram: () => void;
  /** The button that connects a timer. */
  readonly connect: ComponentChildren;
  /** The button that prints the memories. */
  readonly print: ComponentChildren;
}

/** All memories of the timer at a glance, or two of them side by side; and the backups. */
export function MemoriesPage({ session, memories, following, onProgram, connect, print }: MemoriesPageProps) {
  const { overview: words, memories: all, views } = messages.value;
  const compared = memories.compared.value;
  const place = useRef<HTMLDivElement>(null);
  const left = useRef<number | null>(null);
  useEffect(() => {
    if (compared) left.current = compared.first;
    else if (left.current !== null) {
      // Puts the focus back where the pilot came from.
      place.current?.querySelector<HTMLElement>(`[data-compare='${left.current}']`)?.focus();
      left.current = null;
    }
  }, [compared]);
  const baseline = session.editor.baseline.value;
  if (baseline && compared) {
    return <MemoryComparison session={session} memories={memories} compared={compared} />;
  }
  return (
    <div class="memories-page" ref={place}>
      <div class="memories-head">
        <h1>{words.title}</h1>
        {baseline && baseline.memory !== null && (
          <div class="buttons">
            {print}
            <button
              type="button"
              disabled={!session.runner.ready.value}
              onClick={() => memories.jobs.open({ kind: 'back-up' })}
            >
              {words.readAll}
            </button>
          </div>
        )}
      </div>
      {baseline ? (
        <MemoryCards session={session} memories={memories} onProgram={onProgram} />
      ) : (
        <>
          <p class="hint">{views.noTimer.memories}</p>
          <div>{connect}</div>
        </>
      )}
      {baseline && session.editor.dirty.value && (
        <p class="hint">
          {words.edited} {all.edited}
        </p>
      )}
      <BackupsPanel session={session} memories={memories} following={following} onLoad={onProgram} />
    </div>
  );
}
