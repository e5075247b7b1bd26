import { fieldKey, type ProgramField } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import type { Session } from '../session/session.js';
import type { WriteFlow } from './write-flow.js';

/**
 * Puts the long DT from before back as an edit, and shows the write.
 * @returns whether the write is shown.
 */
export async function putBackDt({ editor, shortDt }: Session, write: WriteFlow): Promise<boolean> {
  const short = shortDt.held.value;
  const identity = editor.identity.value;
  if (!short || !identity) return false;
  const field: ProgramField = { kind: 'time', slot: identity.functions };
  editor.apply(setValues({ code: 'change', params: { field: fieldKey(field) } }, [{ field, value: short.back }]));
  await write.open();
  return write.current.value !== null;
}
