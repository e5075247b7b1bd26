import type { Heard, LinkState } from '../../serial/index.js';
import type { Platform } from '../browser/platform.js';
import { messages, readable, type Said } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { NoticeText } from '../ui/notice-text.js';
import { ProgressLine } from '../ui/progress-line.js';
import { ConnectionHelp } from './connection-help-view.js';
import './link-notice.css';

/** Characters of a line of text that are shown. */
const LINE = 40;

/** So many rates are tried before the page says what to do. */
const USUAL = 2;

interface LinkNoticeProps {
  readonly session: Session;
  readonly platform: Platform;
  readonly onStop: () => void;
}

/** What is under way until a timer answers: said while it lasts, with the way to stop it. */
export function LinkNotice({ session, platform, onStop }: LinkNoticeProps) {
  const state = session.link.state.value;
  return (
    <>
      <Step session={session} state={state} onStop={onStop} />
      {isSlow(state) && (
        <div class="notices">
          <ConnectionHelp code="waiting" platform={platform} info={state.port.getInfo()} />
        </div>
      )}
    </>
  );
}

/** Whether a timer is looked for longer than it takes to find one that is awake, at a rate that many timers use. */
function isSlow(state: LinkState): state is Extract<LinkState, { status: 'searching' | 'waiting' }> {
  return state.status === 'waiting' || (state.status === 'searching' && state.step > USUAL);
}

interface StepProps {
  readonly session: Session;
  readonly state: LinkState;
  readonly onStop: () => void;
}

function Step({ session, state, onStop }: StepProps) {
  const { link } = messages.value;
  switch (state.status) {
    case 'opening':
      return state.refusals === 0 ? (
        <ProgressLine label={link.opening} progress={null} onStop={onStop} />
      ) : (
        <Waiting said={link.refused} onStop={onStop} />
      );
    case 'searching':
      return (
        <ProgressLine
          label={link.searching(state.baudRate)}
          progress={state.steps > 1 ? { done: state.step - 1, total: state.steps } : null}
          onStop={onStop}
        />
      );
    case 'waiting':
      return (
        <Waiting
          said={state.heard ? heardSaid(state.heard) : link.waiting}
          detail={state.asked > 0 && link.asked(state.asked)}
          onChoose={state.heard ? () => void session.chooseAnother() : undefined}
          onStop={onStop}
        />
      );
    case 'away':
      return <Waiting said={state.unplugged ? link.away : link.brokenOff} onStop={onStop} />;
    case 'closing':
      return <ProgressLine label={link.closing} progress={null} />;
    default:
      return null;
  }
}

/** Of text the last line that came whole, as far as it is short. */
function heardSaid({ kind, sample, baudRate }: Heard): Said {
  const lines = readable(sample).split(/·+/);
  const line = lines.at(-2) || lines.at(-1) || '';
  return messages.value.link.heard[kind](line.trim().slice(-LINE), baudRate);
}

interface WaitingProps {
  readonly said: Said;
  readonly detail?: string | false;
  readonly onChoose?: (() => void) | undefined;
  readonly onStop: () => void;
}

function Waiting({ said, detail, onChoose, onStop }: WaitingProps) {
  const { link } = messages.value;
  return (
    <div class="notices">
      <div class="notice waiting">
        <div role="status">
          <NoticeText said={said} />
        </div>
        {detail && <span class="hint">{detail}</span>}
        {onChoose && (
          <button type="button" onClick={onChoose}>
            {link.chooseAnother}
          </button>
        )}
        <button type="button" onClick={onStop}>
          {link.stop}
        </button>
      </div>
    </div>
  );
}
