import { fieldKey, type ProgramField } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import type { Session } from '../work/session.js';
import type { WriteJob } from './write-job.js';

/** Puts the long DT from before back as an edit, and writes it alone. Settles when the pilot has left that write. */
export async function putBackDt(
  { editor, shortDt, reader }: Pick<Session, 'editor' | 'shortDt' | 'reader'>,
  write: WriteJob,
) {
  const short = shortDt.held.value;
  const identity = editor.identity.value;
  // It is of the memory that flies next, whichever is on the screen.
  if (!short || !identity || !(await reader.showNext())) return;
  const field: ProgramField = { kind: 'time', slot: identity.functions };
  editor.apply(setValues({ code: 'change', params: { field: fieldKey(field) } }, [{ field, value: short.back }]));
  await write.open({ kind: 'edits', only: [field] });
}
