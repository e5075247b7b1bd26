import { useRef } from 'preact/hooks';
import { ConnectButtons } from '../connect/connect-buttons.js';
import { LinkNotice } from '../connect/link-notice.js';
import { messages, timerName } from '../messages/index.js';
import { useModels } from '../models.js';
import { ProgressLine } from '../ui/progress-line.js';
import { useHeight } from '../ui/use-height.js';
import { UncertainBand } from '../write/uncertain-band.js';
import { NoticeBar } from './notice-bar.js';

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
