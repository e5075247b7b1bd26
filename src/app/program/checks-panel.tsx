import { computed } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { type Finding, fieldKey } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { fixFor } from '../editing/fixes.js';
import { fieldName, figureText, messages } from '../messages/index.js';
import { useLate } from '../ui/use-late.js';
import { allNotes } from '../work/field-notes.js';
import './checks-panel.css';

/** All notes about the program, each with its correction where that is obvious. */
export function ChecksPanel({ editor }: { readonly editor: Editor }) {
  const { program } = messages.value;
  // A frame later, like the picture above it: the field that was typed into is drawn first, with its own notes.
  const said = useMemo(() => computed(() => ({ identity: editor.identity.value, notes: allNotes(editor) })), [editor]);
  const [late] = useLate(said);
  const { identity, notes } = late.identity === editor.identity.value ? late : said.peek();
  if (!identity) return null;
  return (
    <section class={`checks ${notes.length === 0 ? 'quiet' : ''}`}>
      <h2>
        {program.findings} {notes.length > 0 && <span class="count">{notes.length}</span>}
      </h2>
      {notes.length === 0 ? (
        <p class="hint">{program.noFindings}</p>
      ) : (
        <ul class="stack gap-3">
          {notes.map(({ field, severity, text, finding }) => (
            // The figures in its text change with each digit, but the element stays the same.
            <li key={`${field ? fieldKey(field) : ''} ${finding?.code}`} class={severity}>
              <strong>{program.severity[severity]}</strong>
              {field && <span class="where">{fieldName(identity, field)}</span>}
              <span>{text}</span>
              {finding && <FixButton editor={editor} finding={finding} />}
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}

function FixButton({ editor, finding }: { readonly editor: Editor; readonly finding: Finding }) {
  const { edits } = messages.value;
  const fix = useMemo(
    () => computed(() => (editor.working.value && fixFor(finding, editor.working.value)?.value) ?? null),
    [editor, finding],
  );
  const identity = editor.identity.value;
  const { field } = finding;
  const { value } = fix;
  if (!field || value === null || !identity) return null;
  const shown = figureText(identity, field, value);
  return (
    <button
      type="button"
      class="fix"
      aria-label={edits.fixOf({ field: fieldName(identity, field), value: shown })}
      onClick={() =>
        editor.apply(setValues({ code: 'change', params: { field: fieldKey(field) } }, [{ field, value }]))
      }
    >
      {edits.fix({ value: shown })}
    </button>
  );
}
