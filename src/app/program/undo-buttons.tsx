import { useComputed } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Editor } from '../editing/editor.js';
import type { StepName } from '../editing/history.js';
import { messages, stepText } from '../messages/index.js';
import type { Session } from '../session/session.js';
import type { WriteFlow } from '../write/write-flow.js';
import './undo-buttons.css';

/** Undo and redo, with the name of what they would do; by keys everywhere on the page but in texts that are no part of the program. */
export function UndoButtons({ session, write }: { readonly session: Session; readonly write: WriteFlow }) {
  const { editor } = session;
  const { edits } = messages.value;
  const identity = editor.identity.value;
  // What the servos follow is sent one by one: an undo between two commands is followed too.
  const off = useComputed(
    () => (session.runner.busy.value && session.runner.job.value?.kind !== 'bench') || write.current.value !== null,
  );
  const isOff = off.value;
  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => undoByKey(event, off.peek() ? null : editor);
    document.addEventListener('keydown', onKey);
    return () => document.removeEventListener('keydown', onKey);
  }, [editor]);
  if (!identity) return null;
  const named = (plain: string, full: (step: string) => string, step: StepName | null): string =>
    step ? full(stepText(identity, step)) : plain;
  const undo = named(edits.undoButton, edits.undo, editor.undoStep.value);
  const redo = named(edits.redoButton, edits.redo, editor.redoStep.value);
  return (
    <div class="undo-buttons">
      <button
        type="button"
        class="quiet"
        aria-label={undo}
        title={undo}
        disabled={isOff || !editor.undoStep.value}
        onClick={() => editor.undo()}
      >
        {edits.undoButton}
      </button>
      <button
        type="button"
        class="quiet"
        aria-label={redo}
        title={redo}
        disabled={isOff || !editor.redoStep.value}
        onClick={() => editor.redo()}
      >
        {edits.redoButton}
      </button>
    </div>
  );
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
