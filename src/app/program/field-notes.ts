import { type Finding, fieldKey, fieldsOf, type ProgramField, type Severity } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { findingText, messages } from '../messages/index.js';

/** One note about a field. */
export interface FieldNote {
  readonly field: ProgramField;
  readonly severity: Severity;
  readonly text: string;
}

const NONE: readonly FieldNote[] = [];

export function isSameNote(a: FieldNote, b: FieldNote): boolean {
  return a.text === b.text && a.severity === b.severity && fieldKey(a.field) === fieldKey(b.field);
}

/** The notes about one field: that its text is not a value, or else what the check found. */
export function notesFor(editor: Editor, field: ProgramField): readonly FieldNote[] {
  const key = fieldKey(field);
  const unreadable = editor.unreadable.value.get(key);
  // While somebody types, `2` may become `2:30`.
  if (unreadable?.either && !editor.asked.value.has(key)) return NONE;
  if (unreadable) return [{ field, severity: 'error', text: messages.value.unreadable[unreadable.reason] }];
  const found = editor.findingsAt.value.get(key);
  return found ? found.map((finding) => ({ field, severity: finding.severity, text: findingText(finding) })) : NONE;
}

/** The first field that prevents a write, and why; null for none. */
export function firstInTheWay(editor: Editor): { readonly field: ProgramField; readonly text: string } | null {
  const identity = editor.identity.value;
  for (const field of identity ? fieldsOf(identity) : []) {
    const unreadable = editor.unreadable.value.get(fieldKey(field));
    const text = unreadable
      ? messages.value.unreadable[unreadable.reason]
      : notesFor(editor, field).find(({ severity }) => severity === 'error')?.text;
    if (text !== undefined) return { field, text };
  }
  return null;
}

/** All notes about the fields, and about the program as a whole. */
export function allNotes(
  editor: Editor,
): { field: ProgramField | null; severity: Severity; text: string; finding: Finding | null }[] {
  const typed = editor.unreadable.value;
  const unreadable = [...typed.values()].filter(
    ({ field, either }) => !either || editor.asked.value.has(fieldKey(field)),
  );
  return [
    ...unreadable.map(({ field, reason }) => ({
      field,
      severity: 'error' as const,
      text: messages.value.unreadable[reason],
      finding: null,
    })),
    ...editor.findings.value
      .filter(({ field }) => !field || !typed.has(fieldKey(field)))
      .map((finding) => ({ field: finding.field, severity: finding.severity, text: findingText(finding), finding })),
  ];
}
