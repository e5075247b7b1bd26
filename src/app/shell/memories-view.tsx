import type { Follow } from '../bench/follow.js';
import type { Memories } from '../memories/memories.js';
import { MemoriesOverview } from '../memories/memories-overview.js';
import { BackupsPanel, MemoriesPanel } from '../memories/memories-panel.js';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';

interface MemoriesViewProps {
  readonly session: Session;
  readonly memories: Memories;
  readonly follow: Follow;
}

/** All memories of the timer at a glance, and what was kept of timers. */
export function MemoriesView({ session, memories, follow }: MemoriesViewProps) {
  const { names, noTimer } = messages.value.views;
  return (
    <>
      <h1>{names.memories}</h1>
      {!session.editor.baseline.value && <p class="hint">{noTimer.memories}</p>}
      <MemoriesPanel session={session} memories={memories} />
      <MemoriesOverview session={session} memories={memories} />
      <BackupsPanel session={session} memories={memories} following={follow.on.value} />
    </>
  );
}
