import { moreMessages } from '../messages/more.js';
import { CancelButton } from '../ui/form-buttons.js';
import { Modal } from '../ui/modal.js';
import type { Session } from '../work/session.js';
import { ClosingButtons } from '../write/dialog-steps.js';
import { UncertainNote } from '../write/uncertain-note.js';
import type { Erase } from './erase.js';

/** Says what would be deleted from this device, and asks once. */
export function EraseDialog({ session, erase }: { readonly session: Session; readonly erase: Erase }) {
  const { erase: words } = moreMessages.value;
  const step = erase.current.value;
  return (
    <Modal
      open={step !== null}
      title={words.open}
      head={<UncertainNote session={session} />}
      held={step === 'running'}
      onEscape={() => erase.dismiss()}
    >
      {step === 'review' && <Review erase={erase} uncertain={session.knowledge.uncertain.value.length > 0} />}
      {step === 'running' && <p role="status">{words.running}</p>}
      {step === 'failed' && (
        <>
          <div class="notice bad" role="alert">
            <p>{words.failed}</p>
          </div>
          <ClosingButtons onClose={() => erase.dismiss()} />
        </>
      )}
    </Modal>
  );
}

interface ReviewProps {
  readonly erase: Erase;
  /** Whether the content of some memory is uncertain: that would be forgotten, too. */
  readonly uncertain: boolean;
}

function Review({ erase, uncertain }: ReviewProps) {
  const { erase: words } = moreMessages.value;
  return (
    <>
      <p>{words.lead}</p>
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
