import { messages } from '../messages/index.js';
import type { UpdateOffer } from './update-offer.js';

interface UpdateNoticeProps {
  readonly update: UpdateOffer;
  /** Whether bytes move: then the question comes afterwards. */
  readonly busy: boolean;
}

/** Says that a new version is ready; once the pilot has accepted it, what it waits for. */
export function UpdateNotice({ update, busy }: UpdateNoticeProps) {
  const { update: words } = messages.value;
  const take = update.take.value;
  const taken = update.taken.value;
  const waitsFor = update.waitsFor.value;
  if (busy || (!take && !(taken && waitsFor))) return null;
  return (
    <div class="notice">
      <p>
        <strong>{taken ? words.waits(update.version.value) : words.ready(update.version.value)}</strong>{' '}
        {waitsFor && words.later[waitsFor]}
      </p>
      {take && (
        <button type="button" onClick={take}>
          {words.take}
        </button>
      )}
      {update.releases.value.length > 0 && (
        <button type="button" class="quiet" onClick={() => update.read(true)}>
          {words.news}
        </button>
      )}
    </div>
  );
}
