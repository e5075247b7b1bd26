import type { ReadonlySignal } from '@preact/signals';
import { type Change, fieldKey } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Editor } from '../editing/editor.js';
import { cellFor, type GridRange } from '../editing/grid.js';
import { type PasteProblem, pasted, previewPaste } from '../editing/paste.js';
import { changeText, gridLabel, messages, pasteProblemText, spokenTime } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { CancelButton } from '../ui/form-buttons.js';
import { Modal } from '../ui/modal.js';
import { UncertainNote } from '../write/uncertain-band.js';
import './paste-dialog.css';

/** A text to paste, and where. */
export interface Pasting {
  readonly range: GridRange;
  readonly text: string;
}

/** How many problems are named. */
const TOLD = 8;

interface PasteDialogProps {
  readonly session: Session;
  /** The text to paste; null while the dialog is closed. */
  readonly pasting: ReadonlySignal<Pasting | null>;
  readonly onClose: () => void;
}

/** Shows what a paste would do, and asks. */
export function PasteDialog({ session, pasting: { value }, onClose }: PasteDialogProps) {
  const { pasting: words } = messages.value.edits;
  return (
    <Modal open={value !== null} title={words.title} head={<UncertainNote session={session} />} onEscape={onClose}>
      {value && <Preview editor={session.editor} pasting={value} close={onClose} />}
    </Modal>
  );
}

/** The changes in the order in which the table shows them. */
function byFunction(changes: readonly Change[]): readonly Change[] {
  const rowOf = ({ field }: Change): number => cellFor(field)?.row ?? Number.POSITIVE_INFINITY;
  return [...changes].sort((a, b) => rowOf(a) - rowOf(b));
}

/** Where a problem is: in the program, or, for what has no place there, in the pasted text. */
function placeOf(identity: Identity, { field, row, column }: PasteProblem): string {
  if (field) return gridLabel(identity, field);
  return messages.value.edits.pasting.place(row + 1, column + 1);
}

interface PreviewProps {
  readonly editor: Editor;
  readonly pasting: Pasting;
  readonly close: () => void;
}

function Preview({ editor, pasting: { range, text }, close }: PreviewProps) {
  const { program, edits, servoName } = messages.value;
  const { pasting: words } = edits;
  const working = editor.working.value;
  if (!working) return null;
  const { identity } = working;
  const servos = Array.from({ length: identity.servos }, (_, servo) => servoName(servo));
  const headings = [program.time, edits.table.interval, ...servos];
  // The program may change while the dialog is open, as when a timer comes back. What is shown is what will be done.
  const preview = previewPaste(working, range, text, { headings, unreadable: editor.unreadable.value });
  const { changes, problems, readings, ignored } = preview;
  const isNone = preview.values.length === 0;
  const apply = (): void => {
    editor.apply(pasted(preview, true));
    close();
  };
  return (
    <>
      {problems.length > 0 && (
        <div class="notice bad">
          <p>
            <strong>{words.problems(isNone)}</strong>
          </p>
          <ul>
            {problems.slice(0, TOLD).map((problem) => (
              <li key={`${problem.row} ${problem.column} ${problem.code}`}>
                {words.problem(placeOf(identity, problem), problem.text, pasteProblemText(problem))}
              </li>
            ))}
          </ul>
          {problems.length > TOLD && <p>{words.more(problems.length - TOLD)}</p>}
        </div>
      )}
      <p>{words.lead(changes.length, problems.length > 0 && !isNone)}</p>
      {changes.length > 0 && (
        <ul class="paste-changes">
          {byFunction(changes).map((change) => (
            <li key={fieldKey(change.field)}>{changeText(identity, change)}</li>
          ))}
        </ul>
      )}
      {readings.length > 0 && (
        <div class="notice">
          <ul>
            {readings.slice(0, TOLD).map(({ field, text, value }) => (
              <li key={`${field.kind} ${field.slot} ${text}`}>
                {words.reading(gridLabel(identity, field), text, spokenTime(value))}
              </li>
            ))}
          </ul>
          {readings.length > TOLD && <p>{words.more(readings.length - TOLD)}</p>}
        </div>
      )}
      {ignored > 0 && <p class="hint">{words.ignored(ignored)}</p>}
      <div class="buttons">
        <CancelButton onClick={close} />
        <button type="button" class="primary" disabled={isNone} onClick={apply}>
          {problems.length > 0 ? words.applyRest : words.apply}
        </button>
      </div>
    </>
  );
}
