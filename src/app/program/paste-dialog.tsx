import { useSignal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import { type Identity, slotCount } from '../../protocol/index.js';
import { withValues } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { cellFor, TIME_COLUMN } from '../editing/grid.js';
import { type PastePreview, type PasteProblem, pasted, previewPaste } from '../editing/paste.js';
import type { PasteAnswer, PasteQuestion } from '../editing/paste-questions.js';
import { gridLabel, messages, pasteProblemText, slotLabel, spokenTime } from '../messages/index.js';
import { servoName } from '../messages/names.js';
import { type GridRow, ProgramGrid } from '../timeline/program-grid.js';
import { Choice } from '../ui/choice.js';
import { CancelButton } from '../ui/form-buttons.js';
import { Modal } from '../ui/modal.js';
import type { Session } from '../work/session.js';
import { UncertainNote } from '../write/uncertain-note.js';
import type { Pasting, TableModel } from './table-model.js';

/** How much of a list is named. */
const TOLD = 8;

interface PasteDialogProps {
  readonly session: Session;
  readonly table: TableModel;
}

/** Shows what a paste would do, and asks. */
export function PasteDialog({ session, table }: PasteDialogProps) {
  const { value: pasting } = table.pasting;
  const { apply } = messages.value.edits.pasting;
  const close = (): void => table.pasted();
  return (
    <Modal open={pasting !== null} title={apply} head={<UncertainNote session={session} />} onEscape={close}>
      {pasting && <Preview editor={session.editor} {...{ pasting, close }} />}
    </Modal>
  );
}

/** Where a problem is: in the program, or, for what has no place there, in the pasted text. */
function placeOf(identity: Identity, { field, row, column }: PasteProblem): string {
  if (field) return gridLabel(identity, field);
  return messages.value.edits.pasting.place({ row: row + 1, column: column + 1 });
}

interface PreviewProps {
  readonly editor: Editor;
  readonly pasting: Pasting;
  readonly close: () => void;
}

function Preview({ editor, pasting: { range, text }, close }: PreviewProps) {
  const { pasting: words } = messages.value.edits;
  const answers = useSignal<ReadonlyMap<string, PasteAnswer>>(new Map());
  const working = editor.working.value;
  if (!working) return null;
  const { identity } = working;
  // The program may change while the dialog is open, as when a timer comes back. What is shown is what will be done.
  const preview = previewPaste(working, range, text, { answers: answers.value, unreadable: editor.unreadable.value });
  const { changes, values, problems, readings, questions } = preview;
  const isOpen = questions.some(({ answer }) => answer === null);
  const apply = (): void => {
    editor.apply(pasted(preview));
    close();
  };
  return (
    <>
      {questions.length > 0 && (
        <div class="notice">
          <p>
            <strong>{words.asks}</strong>
          </p>
          {questions.map((question) => (
            <Question
              key={question.key}
              {...{ identity, question }}
              onAnswer={(answer) => {
                answers.value = new Map(answers.value).set(question.key, answer);
              }}
            />
          ))}
        </div>
      )}
      {problems.length > 0 && (
        <div class="notice bad">
          <p>
            <strong>{words.problems}</strong>
          </p>
          <Told
            texts={problems.map((problem) => {
              const said = { place: placeOf(identity, problem), reason: pasteProblemText(problem) };
              return problem.text === '' ? words.problem(said) : words.problemOf({ ...said, text: problem.text });
            })}
          />
        </div>
      )}
      <p>{words.lead({ count: changes.length })}</p>
      <PasteTable before={working} after={withValues(working, values)} preview={preview} />
      {readings.length > 0 && (
        <div class="notice">
          <Told
            texts={readings.map(({ field, text, value }) =>
              words.reading({ field: gridLabel(identity, field), text, time: spokenTime(value) }),
            )}
          />
        </div>
      )}
      <div class="buttons">
        <CancelButton onClick={close} />
        <button type="button" class="primary" disabled={values.length === 0 || isOpen} onClick={apply}>
          {words.apply}
        </button>
      </div>
    </>
  );
}

function Told({ texts }: { readonly texts: readonly string[] }) {
  return (
    <>
      <ul>
        {texts.slice(0, TOLD).map((text) => (
          <li key={text}>{text}</li>
        ))}
      </ul>
      {texts.length > TOLD && <p>{messages.value.more({ count: texts.length - TOLD })}</p>}
    </>
  );
}

interface QuestionProps {
  readonly identity: Identity;
  readonly question: PasteQuestion;
  readonly onAnswer: (answer: PasteAnswer) => void;
}

/** Asks what a name means that is not known. */
function Question({ identity, question, onAnswer }: QuestionProps) {
  const { pasting: words, opened } = messages.value.edits;
  const names = question.of === 'row' ? rowChoices(identity) : columnChoices(identity);
  const choices = question.answer === null ? [null, ...names.keys()] : [...names.keys()];
  return (
    <Choice<PasteAnswer | null>
      label={
        question.text === ''
          ? words.place({ row: question.row + 1, column: question.column + 1 })
          : opened({ name: question.text })
      }
      choices={choices}
      nameOf={(choice) => (choice === null ? words.choose : (names.get(choice) ?? ''))}
      chosen={question.answer}
      onChoose={(answer) => answer !== null && onAnswer(answer)}
    />
  );
}

function rowChoices(identity: Identity): ReadonlyMap<PasteAnswer, string> {
  const { program, edits } = messages.value;
  const slots = Array.from({ length: slotCount(identity) }, (_, slot) => slot);
  return new Map<PasteAnswer, string>([
    ...slots.map((slot) => [`slot:${slot}`, slotLabel(identity, slot)] as const),
    ...(identity.timerClass === 'Q' ? [['motor', program.motorStop] as const] : []),
    ['none', edits.pasting.leaveOut],
  ]);
}

function columnChoices(identity: Identity): ReadonlyMap<PasteAnswer, string> {
  const { program, edits, times } = messages.value;
  const servos = Array.from({ length: identity.servos }, (_, servo) => servo);
  return new Map<PasteAnswer, string>([
    ['time', `${program.time}, ${times.units.s}`],
    ['minutes', `${program.time}, ${times.units.min}`],
    ['interval', `${edits.table.interval}, ${times.units.s}`],
    ...servos.map((servo) => [`servo:${servo}`, servoName(servo)] as const),
    ['names', program.slot],
    ['none', edits.pasting.leaveOut],
  ]);
}

interface PasteTableProps {
  readonly before: TimerProgram;
  readonly after: TimerProgram;
  readonly preview: PastePreview;
}

/** What goes where: the rows and columns that a paste touches, with the new values over the old ones. */
function PasteTable({ before, after, preview }: PasteTableProps) {
  const cells = [...preview.cells, ...preview.problems, ...preview.changes]
    .map(({ field }) => field && cellFor(field))
    .filter((cell) => cell !== null);
  if (cells.length === 0) return null;
  const isQ = before.identity.timerClass === 'Q';
  // The first time of a Q has the row of the motor stop.
  const rows = new Set<GridRow>(
    cells.map(({ row, column }) => (isQ && row === 0 && column === TIME_COLUMN ? 'motor' : row)),
  );
  return (
    <ProgramGrid
      program={after}
      other={before}
      caption={messages.value.edits.pasting.table}
      columns={[...new Set(cells.map(({ column }) => column))].sort((a, b) => a - b)}
      rows={(row) => rows.has(row)}
      replaces
    />
  );
}
