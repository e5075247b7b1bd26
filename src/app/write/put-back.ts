import { fieldKey, type ProgramField } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import type { Session } from '../work/session.js';
import type { WriteJob } from './write-job.js';

/** Puts the long DT from before back as an edit, and writes it alone. Settles when the pilot has left that write. */
export async function putBackDt({ editor, shortDt }: Pick<Session, 'editor' | 'shortDt'>, write: WriteJob) {
  const short = shortDt.held.value;
  const identity = editor.identity.value;
  if (!short || !identity) return;
  const field: ProgramField = { kind: 'time', slot: identity.functions };
  editor.apply(setValues({ code: 'change', params: { field: fieldKey(field) } }, [{ field, value: short.back }]));
  await write.open({ kind: 'edits', only: [field] });
}
