import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { Modal } from '../ui/modal.js';
import { RunningStep } from '../write/dialog-steps.js';
import { UncertainNote } from '../write/uncertain-band.js';
import type { Leaving } from './leaving.js';
import { nextFlightText } from './next-flight-line.js';

/** Says once more which memory will fly when it is not the one of the time of connect, before the connection ends. */
export function LeaveDialog({ session, leaving }: { readonly session: Session; readonly leaving: Leaving }) {
  const question = leaving.question.value;
  return (
    <Modal
      open={question !== null}
      title={messages.value.nextFlight.leaving.title}
      titleId="leave-title"
      head={<UncertainNote session={session} />}
      held={question?.goingBack === true}
      onEscape={() => leaving.stay()}
    >
      <Question session={session} leaving={leaving} />
    </Modal>
  );
}

function Question({ session, leaving }: { readonly session: Session; readonly leaving: Leaving }) {
  const { nextFlight: words, memoryName, program } = messages.value;
  const question = leaving.question.value;
  const { original, word } = session.nextFlight;
  if (!question) return null;
  if (question.goingBack) {
    return (
      <RunningStep
        label={program.selecting}
        progress={session.runner.job.value?.progress ?? null}
        onStop={() => leaving.stay()}
      />
    );
  }
  const originalName = original.value === null ? null : memoryName(original.value);
  const canGoBack = word.value !== null && originalName !== null && session.runner.ready.value;
  return (
    <>
      {question.failed && originalName && (
        <p class="notice bad" role="alert">
          {words.leaving.failed(originalName)}
        </p>
      )}
      <p role="status">
        <strong>
          {word.value ? nextFlightText(word.value, 'will') : originalName && words.leaving.as(originalName)}
        </strong>
      </p>
      <div class="buttons">
        <button type="button" class="quiet" onClick={() => leaving.stay()}>
          {words.leaving.stay}
        </button>
        <button type="button" onClick={() => void leaving.disconnectAsItIs()}>
          {words.leaving.disconnect}
        </button>
        {canGoBack && (
          <button type="button" class="primary" onClick={() => void leaving.backAndDisconnect()}>
            {words.leaving.back(originalName)}
          </button>
        )}
      </div>
    </>
  );
}
