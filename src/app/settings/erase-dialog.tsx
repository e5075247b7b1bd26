import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { CancelButton } from '../ui/form-buttons.js';
import { Modal } from '../ui/modal.js';
import { ClosingButtons } from '../write/dialog-steps.js';
import { UncertainNote } from '../write/uncertain-note.js';
import type { Erase, KeptCounts } from './erase.js';

/** Shows what would be deleted from this device, and asks once. */
export function EraseDialog({ session, erase }: { readonly session: Session; readonly erase: Erase }) {
  const { erase: words } = messages.value;
  const current = erase.current.value;
  return (
    <Modal
      open={current !== null}
      title={words.title}
      head={<UncertainNote session={session} />}
      held={current?.step === 'running'}
      onEscape={() => erase.dismiss()}
    >
      {current?.step === 'review' && (
        <Review erase={erase} counts={current.counts} uncertain={session.knowledge.uncertain.value.length > 0} />
      )}
      {current?.step === 'running' && <p role="status">{words.running}</p>}
      {current?.step === 'failed' && (
        <>
          <div class="notice bad" role="alert">
            <p>{words.failed(current.left)}</p>
          </div>
          <ClosingButtons onClose={() => erase.dismiss()} />
        </>
      )}
    </Modal>
  );
}

interface ReviewProps {
  readonly erase: Erase;
  readonly counts: KeptCounts;
  /** Whether the content of some memory is uncertain: that would be forgotten, too. */
  readonly uncertain: boolean;
}

function Review({ erase, counts, uncertain }: ReviewProps) {
  const { erase: words } = messages.value;
  // Lines that say 0 would hide those that say what is lost.
  const kept = (Object.keys(words.counts) as (keyof KeptCounts)[]).filter((shelf) => counts[shelf] !== 0);
  return (
    <>
      <p>{words.lead}</p>
      <ul>
        {kept.map((shelf) => (
          <li key={shelf}>{words.counts[shelf](String(counts[shelf] ?? words.unknown))}</li>
        ))}
        {words.rest.map((each) => (
          <li key={each}>{each}</li>
        ))}
      </ul>
      {uncertain && (
        <div class="notice bad" role="alert">
          <p>{words.uncertain}</p>
        </div>
      )}
      <div class="buttons">
        <CancelButton onClick={() => erase.dismiss()} />
        <button type="button" class="danger" onClick={() => void erase.start()}>
          {words.start}
        </button>
      </div>
    </>
  );
}
