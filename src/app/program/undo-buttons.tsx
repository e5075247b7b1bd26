import { useComputed } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { shortcutLetter } from '../browser/shortcut-letter.js';
import type { Editor } from '../editing/editor.js';
import { messages, stepText } from '../messages/index.js';
import type { Session } from '../work/session.js';
import type { WriteJob } from '../write/write-job.js';
import './undo-buttons.css';

/**
 * Undo and redo, with the name of the step. Their keys work everywhere on the page, except in texts that do not belong
 * to the program.
 */
export function UndoButtons({ session, write }: { readonly session: Session; readonly write: WriteJob }) {
  const { editor } = session;
  const { edits, undo: undoButton } = messages.value;
  const identity = editor.identity.value;
  // Positions go to the timer one by one while the servos follow. An undo between two commands is followed, too.
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
  // The last step disables its own button, which would lose the focus. So it only says that it is off.
  return (
    <div class="buttons undo-buttons">
      {(
        [
          ['undo', undo, undoButton],
          ['redo', redo, edits.redoButton],
        ] as const
      ).map(([way, step, label]) => (
        <button
          type="button"
          key={way}
          class="quiet"
          aria-label={step ?? label}
          title={step ?? label}
          aria-disabled={isOff || step === null}
          onClick={() => void (!off.peek() && editor[way]())}
        >
          {label}
        </button>
      ))}
    </div>
  );
}

/** The step in words; null when there is none. While somebody types in a field, the words stay the same. */
function useStepText(
  { identity }: Editor,
  step: Editor['undoStep'],
  text: (params: { step: string }) => string,
): string | null {
  return useComputed(() => (identity.value && step.value ? text({ step: stepText(identity.value, step.value) }) : null))
    .value;
}

/**
 * @param editor null while nothing can be undone: the browser's own undo in a field would be no step of the program.
 */
function undoByKey(event: KeyboardEvent, editor: Editor | null): void {
  const { target } = event;
  if (event.defaultPrevented) return;
  const letter = shortcutLetter(event);
  const isRedo = (letter === 'z' && event.shiftKey) || (letter === 'y' && !event.shiftKey);
  if (!isRedo && letter !== 'z') return;
  if (target instanceof Element) {
    const isText = target.matches('input, textarea, select') && !target.closest('.value');
    if (isText || target.closest('dialog')) return;
  }
  event.preventDefault();
  if (isRedo) editor?.redo();
  else editor?.undo();
}
