import type { Heard } from '../../serial/index.js';
import { messages, readable, type Said } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { NoticeText } from '../ui/notice-text.js';
import { ProgressLine } from '../ui/progress-line.js';

/** Characters of a line of text that are shown. */
const LINE = 40;

/** What is under way until a timer answers: said while it lasts, with the way to stop it. */
export function LinkNotice({ session, onStop: stop }: { readonly session: Session; readonly onStop: () => void }) {
  const { link } = messages.value;
  const state = session.link.state.value;
  switch (state.status) {
    case 'opening':
      return state.refusals === 0 ? (
        <ProgressLine label={link.opening} progress={null} onStop={stop} />
      ) : (
        <Waiting said={link.refused} onStop={stop} />
      );
    case 'searching':
      return (
        <ProgressLine
          label={link.searching(state.baudRate)}
          progress={state.steps > 1 ? { done: state.step - 1, total: state.steps } : null}
          onStop={stop}
        />
      );
    case 'waiting':
      return (
        <Waiting
          said={state.heard ? heardSaid(state.heard) : link.waiting}
          detail={state.asked > 0 && link.asked(state.asked)}
          onChoose={state.heard ? () => void session.chooseAnother() : undefined}
          onStop={stop}
        />
      );
    case 'away':
      return <Waiting said={state.unplugged ? link.away : link.brokenOff} onStop={stop} />;
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
  readonly said: { readonly title: string; readonly advice: string };
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
