import { moreMessages } from '../messages/more.js';
import type { Session } from '../work/session.js';
import type { Browse } from './browse.js';
import { SettingList } from './setting-list.js';

interface LibraryBeginningProps {
  readonly session: Session;
  readonly browse: Browse;
}

/** Stands beside the models while none is chosen: the latest changes, or in an empty library what it is for. */
export function LibraryBeginning({ session, browse }: LibraryBeginningProps) {
  const { models } = moreMessages.value.library;
  const records = browse.latest.value;
  if (records.length > 0) {
    return (
      <>
        <h2>{models.latest}</h2>
        <SettingList {...{ session, records }} chosen={null} withModel />
      </>
    );
  }
  return session.library.models.list.value.length === 0 ? <EmptyWords /> : null;
}

/** What an empty library is for, and how it begins. */
export function EmptyWords() {
  const { empty } = moreMessages.value.library;
  return (
    <div class="stack library-empty">
      <h2>{empty.title}</h2>
      <p>{empty.lead}</p>
      <p class="hint">{empty.hint}</p>
    </div>
  );
}
