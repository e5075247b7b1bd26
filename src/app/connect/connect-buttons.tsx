import { messages } from '../messages/index.js';
import type { Session } from '../work/session.js';

interface ConnectButtonsProps {
  readonly session: Session;
  readonly large?: boolean;
  /** Where there is no room for all buttons: `first` is the most wanted one. Default: all. */
  readonly part?: 'first' | 'rest';
}

/**
 * Connect, or Read after a failed first reading. Choose another adapter, for when the last one is wrong. With a program
 * on the screen, also the way back to the start. Without an adapter Connect comes back to what a simulated timer holds.
 */
export function ConnectButtons({ session, large = false, part }: ConnectButtonsProps) {
  const { header, program } = messages.value;
  const notice = session.notices.current.value;
  const failed = notice?.kind === 'connection' && notice.code !== 'nothing-chosen';
  // A changed program has its own way to the timer.
  const leads = large || session.editor.changes.value.length === 0;
  const isBack = session.timer.holdsSimulated && session.link.ports.value.length === 0;
  const choice = failed || isBack || session.link.ports.value.length > 0;
  const connect = part !== 'rest' && !session.link.unavailable && (
    <button
      type="button"
      class={large ? 'primary large' : leads ? 'primary' : ''}
      data-lead="connect"
      disabled={session.engaged.value}
      onClick={() => void (isBack ? session.timer.comeBack() : session.timer.connect())}
    >
      {session.connection.value ? program.read : header.connect}
    </button>
  );
  return (
    <>
      {large && connect}
      {part !== 'first' && session.editor.working.value && !session.connection.value && (
        <button
          type="button"
          class="quiet"
          disabled={session.engaged.value}
          onClick={() => session.onScreen.closeProgram()}
        >
          {header.closeProgram}
        </button>
      )}
      {part !== 'first' && choice && (
        <button type="button" disabled={session.engaged.value} onClick={() => void session.timer.connect(true)}>
          {header.choosePort}
        </button>
      )}
      {/* Where Disconnect was: a second click on it must not close the program. */}
      {!large && connect}
    </>
  );
}
