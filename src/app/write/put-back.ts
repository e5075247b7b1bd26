import { fieldKey, type ProgramField } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import type { Session } from '../session/session.js';
import type { WriteFlow } from './write-flow.js';

/**
 * Puts a short DT back to the long one from before, as an edit, and shows it as any write is shown.
 * @returns whether that is shown now.
 */
export async function putBackDt({ editor, shortDt }: Session, write: WriteFlow): Promise<boolean> {
  const short = shortDt.held.value;
  const identity = editor.identity.value;
  if (!short || !identity) return false;
  const field: ProgramField = { kind: 'time', slot: identity.functions };
  editor.apply(setValues({ code: 'preset', params: { field: fieldKey(field) } }, [{ field, value: short.back }]));
  await write.open();
  return write.current.value !== null;
}
