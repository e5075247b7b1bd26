import { whole } from '../messages/dotted.js';
import { dtText, messages, shortDtText } from '../messages/index.js';
import { Modal } from '../ui/modal.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import { UncertainNote } from '../write/uncertain-note.js';
import { nextFlightText } from '../write/unfinished-text.js';
import type { WriteJob } from '../write/write-job.js';
import type { Leaving } from './leaving.js';
import './leave-dialog.css';

/** Before the connection ends: warns when another memory than is meant will fly, or one with a short DT. */
export function LeaveDialog({ session, leaving }: { readonly session: Session; readonly leaving: Leaving }) {
  const question = leaving.question.value;
  return (
    <Modal
      open={question !== null}
      title={messages.value.nextFlight.leaving.title}
      head={<UncertainNote session={session} />}
      onEscape={() => leaving.answer('stay')}
    >
      <Question session={session} leaving={leaving} />
    </Modal>
  );
}

function Question({ session, leaving }: { readonly session: Session; readonly leaving: Leaving }) {
  const { nextFlight: words, shortDt, cancel } = messages.value;
  const question = leaving.question.value;
  const { original, word } = session.nextFlight;
  if (!question) return null;
  const originalName = original.value === null ? null : memoryText(session, original.value);
  const canGoBack = word.value !== null && originalName !== null && session.runner.ready.value;
  const short = session.shortDt.held.value;
  const dt = short && dtText(short.dt);
  const shortMemory = short && short.memory !== null ? memoryText(session, short.memory) : null;
  const leaveMemory = word.value && shortMemory;
  const asksMemory = word.value !== null || short === null;
  const blocked = session.editor.blocked.value;
  return (
    <>
      {question === 'failed' && originalName && (
        <p class="notice bad" role="alert">
          {words.leaving.failed({ original: originalName })}
        </p>
      )}
      <div role="status">
        {asksMemory && (
          <p>
            <strong>
              {word.value
                ? nextFlightText(session, word.value, 'now')
                : originalName && words.other({ memory: originalName })}
            </strong>
          </p>
        )}
        {short && dt && (
          <p>
            <strong>{shortDtText(shortMemory, dt)}</strong>{' '}
            {shortDt.ask({ back: whole(dtText(short.back)), remembered: short.remembered })}
          </p>
        )}
        {short && blocked && <p class="hint">{shortDt.blocked}</p>}
      </div>
      <div class={`buttons leave-ways ${short ? 'many' : ''}`}>
        <button type="button" class="quiet" onClick={() => leaving.answer('stay')}>
          {cancel}
        </button>
        <button type="button" onClick={() => leaving.answer('leave')}>
          {leaveText(dt, leaveMemory)}
        </button>
        {short && (
          <button
            type="button"
            class={canGoBack ? undefined : 'primary'}
            disabled={blocked || !session.runner.ready.value}
            onClick={() => leaving.answer('put-back')}
          >
            {shortDt.putBack({ back: whole(dtText(short.back)), remembered: short.remembered })}
          </button>
        )}
        {canGoBack && (
          <button type="button" class="primary" onClick={() => leaving.answer('back')}>
            {words.leaving.back({ original: originalName })}
          </button>
        )}
      </div>
    </>
  );
}

/** Under the result of the write that has put DT back: the pilot wanted to disconnect. */
export function GoOn({ write, leaving }: { readonly write: WriteJob; readonly leaving: Leaving }) {
  if (!leaving.puttingBack.value) return null;
  const goOn = (): void => {
    leaving.answer('leave');
    write.dismiss();
  };
  return (
    <div class="buttons">
      <button type="button" class="primary" onClick={goOn}>
        {messages.value.header.disconnect}
      </button>
    </div>
  );
}

/** What disconnecting leaves in the timer. @param memory null for the one that was current when the pilot connected. */
function leaveText(dt: string | null, memory: string | null): string {
  const { shortDt, header } = messages.value;
  if (dt === null) return header.disconnect;
  return memory === null ? shortDt.disconnectHere({ dt: whole(dt) }) : shortDt.disconnect({ memory, dt: whole(dt) });
}
