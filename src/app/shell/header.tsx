import { useRef } from 'preact/hooks';
import type { Platform } from '../browser/platform.js';
import { ConnectButtons } from '../connect/connect-buttons.js';
import { LinkNotice } from '../connect/link-notice.js';
import type { Leaving } from '../memories/leaving.js';
import type { Memories } from '../memories/memories.js';
import { messages, timerName } from '../messages/index.js';
import type { JobKind, JobRunner } from '../session/job-runner.js';
import type { Keeping } from '../session/keeping.js';
import type { Link } from '../session/link.js';
import type { PortHolder } from '../session/port-holder.js';
import type { Session } from '../session/session.js';
import type { SetAside } from '../session/set-aside.js';
import { ProgressLine } from '../ui/progress-line.js';
import { useHeight } from '../ui/use-height.js';
import { UncertainBand } from '../write/uncertain-band.js';
import { NoticeBar } from './notice-bar.js';
import type { UpdateOffer } from './update-offer.js';
import './header.css';

interface HeaderProps {
  readonly session: Session;
  readonly memories: Memories;
  readonly leaving: Leaving;
  readonly keeping: Keeping;
  readonly aside: SetAside;
  readonly update: UpdateOffer;
  readonly portHolder: PortHolder;
  readonly platform: Platform;
}

/**
 * What stays in sight: the name of the program, what it is connected to, the buttons that change that, and what there
 * is to say.
 */
export function Header({ session, memories, leaving, keeping, aside, update, portHolder, platform }: HeaderProps) {
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
        <LinkState link={session.link} />
        <div class="top-actions">
          {status === 'off' && session.editor.working.value && <ConnectButtons session={session} />}
          {status === 'on' && (
            <button type="button" class="quiet" onClick={() => void leaving.disconnect()}>
              {header.disconnect}
            </button>
          )}
        </div>
      </div>
      <UncertainBand session={session} onLook={(memory) => void memories.look(memory)} />
      <LinkNotice session={session} platform={platform} onStop={() => void leaving.disconnect()} />
      <JobProgress runner={session.runner} />
      <NoticeBar
        session={session}
        keeping={keeping}
        aside={aside}
        update={update}
        portHolder={portHolder}
        platform={platform}
      />
    </header>
  );
}

const SAID_HERE: ReadonlySet<JobKind> = new Set(['read', 'select', 'look']);

function JobProgress({ runner }: { readonly runner: JobRunner }) {
  const { program, look, memoryName } = messages.value;
  const job = runner.job.value;
  // What the others do is said where they were begun.
  if (!job || !SAID_HERE.has(job.kind) || runner.claimed.value) return null;
  const looking = job.kind === 'look' && job.memory !== null && look.looking(memoryName(job.memory));
  return (
    <ProgressLine
      label={looking || (job.kind === 'select' ? program.selecting : program.reading)}
      progress={job.progress}
      onStop={() => void runner.stop()}
    />
  );
}

function LinkState({ link }: { readonly link: Link }) {
  const { header, link: words } = messages.value;
  const state = link.state.value;
  if (state.status === 'on') {
    const { identity } = state.connection;
    return (
      <p class="link-state on">
        <strong>{timerName(identity)}</strong> <span>{header.firmware(identity.firmware)}</span>
        {link.simulated.value && <span class="badge">{header.simulated}</span>}
      </p>
    );
  }
  const busy = state.status === 'off' ? '' : 'busy';
  const status = state.status === 'away' && !state.unplugged ? 'brokenOff' : state.status;
  return <p class={`link-state ${busy}`}>{words.status[status]}</p>;
}
