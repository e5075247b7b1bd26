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
  const isWaiting = update.taken.value && !update.free.value;
  if (busy || (!take && !isWaiting)) return null;
  return (
    <div class="notice">
      <p>
        <strong>{words.ready}</strong> {!update.free.value && words.waits}
      </p>
      {take && (
        <button type="button" onClick={take}>
          {words.take}
        </button>
      )}
    </div>
  );
}
