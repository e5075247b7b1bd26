import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';

/** Reads the timer once more, and takes back all that was changed. */
export function ReadButtons({ session }: { readonly session: Session }) {
  const { program } = messages.value;
  const { editor, runner } = session;
  const { status } = session.link.state.value;
  return (
    <>
      {status !== 'off' && (
        <button
          type="button"
          aria-disabled={runner.busy.value}
          disabled={status !== 'on'}
          onClick={() => void session.reader.read()}
        >
          {program.read}
        </button>
      )}
      {editor.dirty.value && (
        <button type="button" class="quiet" disabled={runner.busy.value} onClick={() => editor.revertAll()}>
          {program.undoAll}
        </button>
      )}
    </>
  );
}
