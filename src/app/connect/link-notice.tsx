import type { Platform } from '../browser/platform.js';
import { messages } from '../messages/index.js';
import type { Session } from '../work/session.js';
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
  const state = session.link.state.value;
  const waiting = waitingFor(state, session.link.waited.value);
  if (!waiting || state.status === 'choosing') return null;
  const { said, now, canChoose, help } = waiting;
  return (
    <div class="notices">
      <div class="notice">
        <p>
          <span role="status">
            <strong>{said.title}</strong> {said.advice}
          </span>{' '}
          {now}
        </p>
        {help && <ConnectionHelp code={help} platform={platform} link={session.link} />}
        {canChoose && <ChooseAnother session={session} />}
        {state.status !== 'closing' && (
          <button type="button" onClick={onStop}>
            {messages.value.header.stop}
          </button>
        )}
      </div>
    </div>
  );
}
