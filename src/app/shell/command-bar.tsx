import { useRef } from 'preact/hooks';
import type { Bench } from '../bench/bench.js';
import type { Follow } from '../bench/follow.js';
import { FollowNote } from '../bench/follow-panel.js';
import { messages } from '../messages/index.js';
import { UndoButtons } from '../program/undo-buttons.js';
import { BlockedNote, WriteButton } from '../program/write-button.js';
import type { Session } from '../session/session.js';
import { useHeight } from '../ui/use-height.js';
import type { WriteFlow } from '../write/write-flow.js';
import './command-bar.css';

interface CommandBarProps {
  readonly session: Session;
  readonly write: WriteFlow;
  readonly bench: Bench;
  readonly follow: Follow;
  /** Where there is no room for it beside the table: whether the picture is shown in its place. */
  readonly picture: { readonly open: boolean; readonly onToggle: () => void } | null;
}

/** How the program stands to the timer, and the way to it and back. */
export function CommandBar({ session, write, bench, follow, picture }: CommandBarProps) {
  const { program } = messages.value;
  const { editor } = session;
  const connected = session.connection.value !== null;
  const bar = useRef<HTMLElement>(null);
  useHeight(bar, '--bar');
  return (
    <section class="actions" ref={bar}>
      {session.link.state.value.status === 'off' && !session.link.unavailable && (
        <p class="hint">{program.notConnected}</p>
      )}
      <FollowNote session={session} write={write} bench={bench} follow={follow} />
      <BlockedNote editor={editor} />
      <UndoButtons session={session} write={write} />
      {picture && (
        <button type="button" class="quiet" aria-pressed={picture.open} onClick={picture.onToggle}>
          {picture.open ? program.table : program.picture}
        </button>
      )}
      <div class="buttons">
        <button
          type="button"
          aria-disabled={session.runner.busy.value}
          disabled={!connected}
          onClick={() => void session.read()}
        >
          {program.read}
        </button>
        {editor.dirty.value && (
          <button type="button" class="quiet" disabled={session.runner.busy.value} onClick={() => editor.revertAll()}>
            {program.undoAll}
          </button>
        )}
        <WriteButton session={session} write={write} />
      </div>
    </section>
  );
}
