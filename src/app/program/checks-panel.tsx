import { type Finding, fieldKey } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import { fixFor } from '../editing/fixes.js';
import { fieldLabel, figureText, messages } from '../messages/index.js';
import { useModels } from '../models.js';
import { useSteady } from '../ui/use-steady.js';
import { allNotes } from './field-notes.js';

/** Everything that is to be said about the program, with what puts it right where that is obvious. */
export function ChecksPanel() {
  const { session } = useModels();
  const { program } = messages.value;
  const identity = session.editor.identity.value;
  const notes = allNotes(session.editor);
  if (!identity) return null;
  return (
    <section class="checks">
      <h2>{program.findings}</h2>
      {notes.length === 0 ? (
        <p class="hint">{program.noFindings}</p>
      ) : (
        <ul>
          {notes.map(({ field, severity, text, finding }) => (
            <li key={`${field ? fieldKey(field) : ''} ${text}`} class={severity}>
              <strong>{program.severity[severity]}</strong>
              {field && <span class="where">{fieldLabel(identity, field)}</span>}
              <span>{text}</span>
              {finding && <FixButton finding={finding} />}
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}

function FixButton({ finding }: { readonly finding: Finding }) {
  const { session } = useModels();
  const { edits } = messages.value;
  const { editor } = session;
  const fix = useSteady(() => editor.working.value && fixFor(finding, editor.working.value), [editor, finding]);
  const identity = editor.identity.value;
  if (!fix || !identity) return null;
  const { field, value } = fix;
  const shown = figureText(identity, field, value);
  return (
    <button
      type="button"
      class="fix"
      aria-label={edits.fixOf(fieldLabel(identity, field), shown)}
      onClick={() => editor.apply(setValues({ code: 'fix', params: { field: fieldKey(field) } }, [fix]))}
    >
      {edits.fix(shown)}
    </button>
  );
}
