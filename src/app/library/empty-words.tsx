import { libraryMessages } from '../messages/en-library.js';

/** What an empty library is for, and how it begins. */
export function EmptyWords() {
  const { empty } = libraryMessages;
  return (
    <>
      <h2>{empty.title}</h2>
      <p>{empty.lead}</p>
      <p class="hint">{empty.hint}</p>
    </>
  );
}
