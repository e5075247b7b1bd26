import { libraryMessages } from '../messages/en-library.js';
import type { Session } from '../session/session.js';
import type { Browse } from './browse.js';
import { EmptyWords } from './empty-words.js';
import { foundText } from './model-list.js';
import { SettingList } from './setting-list.js';
import './library-beginning.css';

interface LibraryBeginningProps {
  readonly session: Session;
  readonly browse: Browse;
}

/**
 * Stands beside the models while none is chosen: what a search finds, the latest changes, or in an empty library what
 * it is for.
 */
export function LibraryBeginning({ session, browse }: LibraryBeginningProps) {
  const { models } = libraryMessages;
  const found = browse.found.value;
  if (found !== null) {
    return (
      <>
        <h2 class="library-latest">
          <span role="status">{foundText(found.length)}</span>
        </h2>
        <SettingList session={session} records={found} chosen={null} withModel />
      </>
    );
  }
  const records = browse.latest.value;
  if (records.length > 0) {
    return (
      <>
        <h2 class="library-latest">{models.latest}</h2>
        <SettingList {...{ session, records }} chosen={null} withModel />
      </>
    );
  }
  if (session.library.models.list.value.length > 0) return null;
  return (
    <div class="stack gap-3 library-none">
      <EmptyWords />
    </div>
  );
}
