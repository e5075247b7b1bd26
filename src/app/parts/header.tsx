import { useRef } from 'preact/hooks';
import { messages, timerName } from '../messages/index.js';
import { useModels } from '../models.js';
import { LinkNotice } from './link-notice.js';
import { NoticeBar } from './notice-bar.js';
import { ProgressLine } from './progress-line.js';
import { UncertainBand } from './uncertain-band.js';
import { useHeight } from './use-height.js';

/** What stays in sight: the name of the program, what it is connected to, the buttons that change that, and what there is to say. */
export function Header() {
  const { session, leaving } = useModels();
  const { name, header } = messages.value;
  const { status } = session.link.state.value;
  const top = useRef<HTMLElement>(null);
  useHeight(top, '--top');
  return (
    <header class="top" ref={top}>
      <div class="top-row">
        <p class="brand">
          <img src="./favicon.svg" alt="" width="32" height="32" />
          <span>{name}</span>
        </p>
        <LinkState />
        <div class="top-actions">
          {status === 'off' && session.editor.working.value && <ConnectButtons />}
          {status === 'on' && (
            <button type="button" class="quiet" onClick={() => void leaving.disconnect()}>
              {header.disconnect}
            </button>
          )}
        </div>
      </div>
      <UncertainBand />
      <LinkNotice />
      <JobProgress />
      <NoticeBar />
    </header>
  );
}

function JobProgress() {
  const { session, memories } = useModels();
  const { program, look, memoryName } = messages.value;
  const job = session.job.value;
  // A write and a job over several memories have a dialog of their own, and what is done on the bench is said there.
  if (!job || job.kind === 'bench' || job.kind === 'write' || memories.current.value) return null;
  const looking = job.kind === 'look' && job.memory !== null && look.looking(memoryName(job.memory));
  return (
    <ProgressLine
      label={looking || (job.kind === 'select' ? program.selecting : program.reading)}
      progress={job.progress}
      onStop={() => job.stop.abort()}
    />
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

function LinkState() {
  const { session } = useModels();
  const { header, link } = messages.value;
  const state = session.link.state.value;
  if (state.status === 'on') {
    const { identity } = state.connection;
    return (
      <p class="link-state on">
        <strong>{timerName(identity)}</strong> <span>{header.firmware(identity.firmware)}</span>
        {session.link.simulated.value && <span class="badge">{header.simulated}</span>}
      </p>
    );
  }
  const busy = state.status === 'off' ? '' : 'busy';
  const status = state.status === 'away' && !state.unplugged ? 'brokenOff' : state.status;
  return <p class={`link-state ${busy}`}>{link.status[status]}</p>;
}
