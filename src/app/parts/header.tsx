import { messages, timerName } from '../messages/index.js';
import { useModels } from '../models.js';
import { NoticeBar } from './notice-bar.js';
import { ProgressLine } from './progress-line.js';

/** What stays in sight: the name of the program, what it is connected to, the buttons that change that, and what there is to say. */
export function Header() {
  const { session } = useModels();
  const { name, header, program } = messages.value;
  const link = session.link.value;
  const job = session.job.value;
  return (
    <header class="top">
      <div class="top-row">
        <p class="brand">
          <img src="./favicon.svg" alt="" width="32" height="32" />
          <span>{name}</span>
        </p>
        <LinkState />
        <div class="top-actions">
          {link.status === 'off' && session.editor.working.value && <ConnectButtons />}
          {link.status === 'opening' && (
            <button type="button" onClick={() => void session.disconnect()}>
              {header.stop}
            </button>
          )}
          {link.status === 'on' && (
            <button type="button" class="quiet" onClick={() => void session.disconnect()}>
              {header.disconnect}
            </button>
          )}
        </div>
      </div>
      {link.status === 'opening' && <ProgressLine label={header.opening} progress={null} />}
      {job && (
        <ProgressLine
          label={job.kind === 'select' ? program.selecting : program.reading}
          progress={job.progress}
          onStop={() => job.stop.abort()}
        />
      )}
      <NoticeBar />
    </header>
  );
}

/** Connect, or Read where the first reading failed; the simulated timer again where the program is of it; Choose a port for when the one used before is the wrong one. */
export function ConnectButtons({ large = false }: { large?: boolean }) {
  const { session } = useModels();
  const { header, program } = messages.value;
  const notice = session.notice.value;
  const timerClass = session.editor.working.value?.identity.timerClass;
  const again = session.simulated.value
    ? (['Q', 'B'] as const).find((simulated) => simulated === timerClass)
    : undefined;
  const failed = notice?.kind === 'connection' && notice.code !== 'nothing-chosen' && notice.code !== 'lost';
  return (
    <>
      {!session.unavailable && (
        <button
          type="button"
          class={large ? 'primary large' : 'primary'}
          disabled={session.busy.value}
          onClick={() => void session.connect()}
        >
          {session.connection.value ? program.read : header.connect}
        </button>
      )}
      {again && (
        <button type="button" disabled={session.busy.value} onClick={() => void session.trySimulated(again)}>
          {header.simulatedTimer}
        </button>
      )}
      {failed && (
        <button type="button" disabled={session.busy.value} onClick={() => void session.connect(true)}>
          {header.choosePort}
        </button>
      )}
    </>
  );
}

function LinkState() {
  const { session } = useModels();
  const { header } = messages.value;
  const link = session.link.value;
  if (link.status === 'on') {
    const { identity } = link.connection;
    return (
      <p class="link-state on">
        <strong>{timerName(identity)}</strong> <span>{header.firmware(identity.firmware)}</span>
        {link.simulated && <span class="badge">{header.simulated}</span>}
      </p>
    );
  }
  const text = { off: header.notConnected, choosing: header.choosing, opening: header.opening }[link.status];
  return <p class="link-state">{text}</p>;
}
