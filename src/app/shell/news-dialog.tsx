import { messages } from '../messages/index.js';
import { Modal } from '../ui/modal.js';
import { ReleaseList } from './release-list.js';
import type { UpdateOffer } from './update-offer.js';

/** What is new in the waiting version. */
export function NewsDialog({ update }: { readonly update: UpdateOffer }) {
  const { update: words } = messages.value;
  const close = (): void => update.read(false);
  const take = update.take.value;
  return (
    <Modal open={update.reading.value} title={words.news} onEscape={close}>
      <ReleaseList releases={update.releases.value} />
      <div class="buttons">
        <button type="button" onClick={close}>
          {messages.value.close}
        </button>
        {take && (
          <button type="button" class="primary" onClick={take}>
            {words.take}
          </button>
        )}
      </div>
    </Modal>
  );
}
