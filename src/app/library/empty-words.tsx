import { libraryMessages } from '../messages/en-library.js';
import type { Session } from '../session/session.js';

/** What an empty library is for, and how it begins. */
export function EmptyWords({ session }: { readonly session: Session }) {
  const { empty } = libraryMessages;
  return (
    <>
      <h2>{empty.title}</h2>
      <p>{empty.lead}</p>
      <p class="hint">{session.editor.working.value ? empty.hint : empty.hintWithout}</p>
    </>
  );
}
