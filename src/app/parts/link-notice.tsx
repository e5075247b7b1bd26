import { messages } from '../messages/index.js';
import { useModels } from '../models.js';
import { NoticeText } from './notice-bar.js';
import { ProgressLine } from './progress-line.js';

/** What is under way until a timer answers: said while it lasts, with the way to stop it. */
export function LinkNotice() {
  const { session, leaving } = useModels();
  const { link } = messages.value;
  const state = session.link.state.value;
  const stop = (): void => void leaving.disconnect();
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
      return <Waiting said={link.waiting} detail={state.asked > 0 && link.asked(state.asked)} onStop={stop} />;
    case 'away':
      return <Waiting said={state.unplugged ? link.away : link.brokenOff} onStop={stop} />;
    case 'closing':
      return <ProgressLine label={link.closing} progress={null} />;
    default:
      return null;
  }
}

interface WaitingProps {
  readonly said: { readonly title: string; readonly advice: string };
  readonly detail?: string | false;
  readonly onStop: () => void;
}

function Waiting({ said, detail, onStop }: WaitingProps) {
  return (
    <div class="notices">
      <div class="notice waiting">
        <div role="status">
          <NoticeText said={said} />
        </div>
        {detail && <span class="hint">{detail}</span>}
        <button type="button" onClick={onStop}>
          {messages.value.link.stop}
        </button>
      </div>
    </div>
  );
}
