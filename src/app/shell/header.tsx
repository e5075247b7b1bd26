import type { ComponentChildren } from 'preact';
import { useRef } from 'preact/hooks';
import type { Follow } from '../bench/follow.js';
import type { Platform } from '../browser/platform.js';
import type { Installation } from '../connect/installation.js';
import { LinkNotice } from '../connect/link-notice.js';
import type { SaveSetting } from '../library/save-setting.js';
import type { Leaving } from '../memories/leaving.js';
import type { Memories } from '../memories/memories.js';
import { NextFlightNotes } from '../memories/next-flight-line.js';
import { messages } from '../messages/index.js';
import type { JobKind, JobRunner } from '../session/job-runner.js';
import type { Keeping } from '../session/keeping.js';
import type { PortHolder } from '../session/port-holder.js';
import type { Preferences } from '../session/preferences.js';
import type { Session } from '../session/session.js';
import type { SetAside } from '../session/set-aside.js';
import { onDemand } from '../ui/on-demand.js';
import { ProgressLine } from '../ui/progress-line.js';
import { useHeight } from '../ui/use-height.js';
import { UncertainBand } from '../write/uncertain-band.js';
import { NoticeBar } from './notice-bar.js';
import { StatusStrip } from './status-strip.js';
import type { UpdateOffer } from './update-offer.js';
import './header.css';

/** The line about the model, loaded after the first picture. */
export const modelLine = onDemand(async () => (await import('../recognition/model-line.js')).ModelLine, {
  silent: true,
});

interface HeaderProps {
  readonly session: Session;
  readonly memories: Memories;
  readonly leaving: Leaving;
  readonly follow: Follow;
  readonly preferences: Preferences;
  readonly saveSetting: SaveSetting;
  readonly keeping: Keeping;
  readonly aside: SetAside;
  readonly update: UpdateOffer;
  readonly portHolder: PortHolder;
  readonly platform: Platform;
  readonly installation: Installation;
  readonly fileNotice: ComponentChildren;
  readonly onExport: () => void;
  /** Whether the connecting is shown large, in place of the program. */
  readonly staged: boolean;
}

/** Stays in sight in every view: the status, what is uncertain, what is in progress, and messages. */
export function Header({
  session,
  memories,
  leaving,
  follow,
  preferences,
  saveSetting,
  staged,
  ...notices
}: HeaderProps) {
  const top = useRef<HTMLElement>(null);
  useHeight(top, '--top');
  return (
    <header class="top" ref={top}>
      <StatusStrip {...{ session, memories, leaving, follow, preferences, saveSetting }} />
      {session.recognition.tells.value && <modelLine.Part recognition={session.recognition} />}
      <NextFlightNotes session={session} memories={memories} />
      <UncertainBand session={session} onLook={(memory) => void memories.look(memory)} />
      {!staged && (
        <>
          <LinkNotice session={session} platform={notices.platform} onStop={() => void leaving.disconnect()} />
          <JobProgress runner={session.runner} />
        </>
      )}
      <NoticeBar session={session} {...notices} />
    </header>
  );
}

const SAID_HERE: ReadonlySet<JobKind> = new Set(['read', 'select', 'look']);

function JobProgress({ runner }: { readonly runner: JobRunner }) {
  const { program, look, memoryName } = messages.value;
  const job = runner.job.value;
  // Other jobs are shown where they were begun.
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
