import type { UnfinishedWrite } from '../storage/index.js';
import type { Session } from '../work/session.js';
import { isHere, isOfKind, uncertainText, whereOf } from './unfinished-text.js';
import './unfinished-band.css';

/**
 * What is uncertain, for a dialog, which covers the page: only about the connected timer, or without one about that of
 * the program on the screen.
 */
export function UncertainNote({ session }: { readonly session: Session }) {
  const shown = session.editor.identity.value;
  const isShown = (one: UnfinishedWrite): boolean =>
    !session.connection.value && shown !== null && isOfKind(whereOf(one), shown, session.simulated.value);
  const here = session.knowledge.uncertain.value.filter((one) => isHere(session, whereOf(one)) || isShown(one));
  if (here.length === 0) return null;
  return (
    <div class="stack uncertain">
      {here.map((one) => (
        <p key={one.key}>{uncertainText(one, null)}</p>
      ))}
    </div>
  );
}
