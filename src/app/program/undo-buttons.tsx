import { useComputed } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Editor } from '../editing/editor.js';
import { messages, stepText } from '../messages/index.js';
import type { Session } from '../session/session.js';
import type { WriteFlow } from '../write/write-flow.js';
import './undo-buttons.css';

/**
 * Undo and redo, with the name of what they would do; by keys everywhere on the page but in texts that are no part of
 * the program.
 */
export function UndoButtons({ session, write }: { readonly session: Session; readonly write: WriteFlow }) {
  const { editor } = session;
  const { edits } = messages.value;
  const identity = editor.identity.value;
  // What the servos follow is sent one by one: an undo between two commands is followed too.
  const off = useComputed(
    () => (session.runner.busy.value && session.runner.job.value?.kind !== 'bench') || write.current.value !== null,
  );
  const isOff = off.value;
  const undo = useStepText(editor, editor.undoStep, edits.undo);
  const redo = useStepText(editor, editor.redoStep, edits.redo);
  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => undoByKey(event, off.peek() ? null : editor);
    document.addEventListener('keydown', onKey);
    return () => document.removeEventListener('keydown', onKey);
  }, [editor]);
  if (!identity) return null;
  return (
    <div class="undo-buttons">
      <button
        type="button"
        class="quiet"
        aria-label={undo ?? edits.undoButton}
        title={undo ?? edits.undoButton}
        disabled={isOff || undo === null}
        onClick={() => editor.undo()}
      >
        {edits.undoButton}
      </button>
      <button
        type="button"
        class="quiet"
        aria-label={redo ?? edits.redoButton}
        title={redo ?? edits.redoButton}
        disabled={isOff || redo === null}
        onClick={() => editor.redo()}
      >
        {edits.redoButton}
      </button>
    </div>
  );
}

/** What would be done, in words; null when there is nothing. While a field is typed in, the words stay the same. */
function useStepText({ identity }: Editor, step: Editor['undoStep'], text: (step: string) => string): string | null {
  return useComputed(() => (identity.value && step.value ? text(stepText(identity.value, step.value)) : null)).value;
}

/** @param editor null while nothing can be undone: a browser would undo in the field what is no step of the program. */
function undoByKey(event: KeyboardEvent, editor: Editor | null): void {
  const { target } = event;
  if (event.defaultPrevented || event.altKey || !(event.ctrlKey || event.metaKey)) return;
  const key = event.key.toLowerCase();
  const isRedo = (key === 'z' && event.shiftKey) || (key === 'y' && !event.shiftKey);
  if (!isRedo && key !== 'z') return;
  if (target instanceof Element) {
    const isText = target.matches('input, textarea, select') && !target.closest('.value');
    if (isText || target.closest('dialog')) return;
  }
  event.preventDefault();
  if (isRedo) editor?.redo();
  else editor?.undo();
}
