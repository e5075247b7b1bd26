import { useComputed } from '@preact/signals';
import { messages } from '../messages/index.js';
import type { Session } from '../work/session.js';
import { readShown } from '../write/edit-memory.js';

/** Buttons that read the timer again, and take back all changes. */
export function ReadButtons({ session }: { readonly session: Session }) {
  const { program } = messages.value;
  const { editor, runner } = session;
  const { status } = session.link.state.value;
  const isDirty = useComputed(() => editor.dirty.value).value;
  const undoAll = (): void => {
    editor.revertAll();
    // This button goes. That one takes back what it did.
    document.querySelector<HTMLElement>('.undo-buttons button')?.focus({ preventScroll: true });
  };
  return (
    <>
      {status !== 'off' && (
        <button
          type="button"
          aria-disabled={runner.busy.value}
          disabled={status !== 'on'}
          onClick={() => void readShown(session)}
        >
          {program.read}
        </button>
      )}
      {isDirty && (
        <button type="button" class="quiet" disabled={runner.busy.value} onClick={undoAll}>
          {program.undoAll}
        </button>
      )}
    </>
  );
}
