import type { Platform } from '../browser/platform.js';
import { messages } from '../messages/index.js';
import { isRateSet, portInfoOf } from '../session/link.js';
import type { Session } from '../session/session.js';
import { ProgressLine } from '../ui/progress-line.js';
import { ConnectionHelp } from './connection-help-view.js';
import { ChooseAnother } from './link-stage.js';
import { waitingFor } from './waiting.js';

interface LinkNoticeProps {
  readonly session: Session;
  readonly platform: Platform;
  readonly onStop: () => void;
}

/** For use beside other content: what the link does until a timer answers, the step to take now, and how to stop. */
export function LinkNotice({ session, platform, onStop }: LinkNoticeProps) {
  const { header, link } = messages.value;
  const state = session.link.state.value;
  const seconds = session.link.waited.value;
  const waiting = waitingFor(state, seconds);
  if (!waiting || state.status === 'choosing') return null;
  const { said, step, canChoose, help } = waiting;
  if (state.status === 'closing') return <ProgressLine label={said.title} progress={null} />;
  if (step === null && help === null && !canChoose)
    return <ProgressLine label={said.title} progress={null} onStop={onStop} />;
  return (
    <div class="notices">
      <div class="notice">
        <p role="status">
          <strong>{said.title}</strong> {said.advice}
        </p>
        {step !== null && <span class="hint">{link.stages.noAnswer(seconds)}</span>}
        {help && (
          <ConnectionHelp code={help} {...{ platform, info: portInfoOf(state), rateSet: isRateSet(session.link) }} />
        )}
        {canChoose && <ChooseAnother session={session} />}
        <button type="button" onClick={onStop}>
          {header.stop}
        </button>
      </div>
    </div>
  );
}
