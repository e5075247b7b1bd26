import { type Finding, fieldKey, fieldsOf, type ProgramField, type Severity } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { findingText, messages } from '../messages/index.js';

/** One note about a field, or about the program as a whole. */
interface Note {
  readonly field: ProgramField | null;
  readonly severity: Severity;
  readonly text: string;
  /** Null where the text of the field is not a value. */
  readonly finding: Finding | null;
}

export interface FieldNote extends Note {
  readonly field: ProgramField;
}

const NONE: readonly FieldNote[] = [];

export function isSameNote(a: FieldNote, b: FieldNote): boolean {
  return a.text === b.text && a.severity === b.severity && fieldKey(a.field) === fieldKey(b.field);
}

function noteOf(finding: Finding): Note {
  return { field: finding.field, severity: finding.severity, text: findingText(finding), finding };
}

/** What prevents a write in this field: its text is not a value. */
function unreadableAt(editor: Editor, field: ProgramField): FieldNote | null {
  const found = editor.unreadable.value.get(fieldKey(field));
  return found ? { field, severity: 'error', text: messages.value.unreadable[found.reason], finding: null } : null;
}

/** The notes about one field: that its text is not a value, or else what the check found. */
export function notesFor(editor: Editor, field: ProgramField): readonly FieldNote[] {
  const key = fieldKey(field);
  const unreadable = unreadableAt(editor, field);
  // While somebody types, `2` may become `2:30`.
  if (editor.unreadable.value.get(key)?.either && !editor.asked.value.has(key)) return NONE;
  if (unreadable) return [unreadable];
  return editor.findingsAt.value.get(key)?.map((finding) => ({ ...noteOf(finding), field })) ?? NONE;
}

/** The first field that prevents a write, and why; null for none. */
export function firstInTheWay(editor: Editor): FieldNote | null {
  const identity = editor.identity.value;
  for (const field of identity ? fieldsOf(identity) : []) {
    const note = unreadableAt(editor, field) ?? notesFor(editor, field).find(({ severity }) => severity === 'error');
    if (note) return note;
  }
  return null;
}

const WORST_FIRST: readonly Severity[] = ['error', 'serious', 'warning'];

/** All notes, the worst first; of one severity, those about the program as a whole last. */
export function allNotes(editor: Editor): readonly Note[] {
  const identity = editor.identity.value;
  const notes: readonly Note[] = [
    ...(identity ? fieldsOf(identity).flatMap((field) => notesFor(editor, field)) : []),
    ...editor.findings.value.filter(({ field }) => !field).map(noteOf),
  ];
  return WORST_FIRST.flatMap((worst) => notes.filter(({ severity }) => severity === worst));
}
