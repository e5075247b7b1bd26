import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';

/**
 * Connect, or Read where the first reading failed; the simulated timer again where the program is of it; Choose a port
 * for when the one used before is the wrong one.
 */
export function ConnectButtons({ session, large = false }: { readonly session: Session; readonly large?: boolean }) {
  const { header, program } = messages.value;
  const notice = session.notices.current.value;
  const timerClass = session.editor.working.value?.identity.timerClass;
  const again = session.simulated.value
    ? (['Q', 'B', 'E'] as const).find((simulated) => simulated === timerClass)
    : undefined;
  const failed = notice?.kind === 'connection' && notice.code !== 'nothing-chosen';
  const choice = failed || session.link.ports.value.length > 0;
  return (
    <>
      {!session.link.unavailable && (
        <button
          type="button"
          class={large ? 'primary large' : 'primary'}
          disabled={session.engaged.value}
          onClick={() => void session.connect()}
        >
          {session.connection.value ? program.read : header.connect}
        </button>
      )}
      {again && (
        <button type="button" disabled={session.engaged.value} onClick={() => void session.trySimulated(again)}>
          {header.simulatedTimer}
        </button>
      )}
      {choice && (
        <button type="button" disabled={session.engaged.value} onClick={() => void session.connect(true)}>
          {header.choosePort}
        </button>
      )}
    </>
  );
}
