import type { ComponentChildren } from 'preact';
import { useRef } from 'preact/hooks';
import { LinkNotice } from '../connect/link-notice.js';
import { NextFlightNotes } from '../memories/next-flight-line.js';
import { UnfinishedBand } from '../memories/unfinished-band.js';
import { messages } from '../messages/index.js';
import { memoryName } from '../messages/names.js';
import type { JobKind, JobRunner } from '../timer/job-runner.js';
import { ProgressLine } from '../ui/progress-line.js';
import { LOW } from '../ui/shapes.js';
import { useHeight } from '../ui/use-height.js';
import { useQuery } from '../ui/use-query.js';
import type { WriteJob } from '../write/write-job.js';
import { NoticeBar, type NoticeBarProps } from './notice-bar.js';
import { StatusStrip, type StatusStripProps } from './status-strip.js';
import './header.css';

interface HeaderProps extends StatusStripProps, NoticeBarProps {
  readonly write: WriteJob;
  /** The line about the model of the timer. */
  readonly recognized: ComponentChildren;
}

/** Stays in sight in every view: the status, what is unfinished, what is in progress, and messages. */
export function Header(props: HeaderProps) {
  const { session, memories, leaving, follow, staged, write, recognized, platform } = props;
  const top = useRef<HTMLElement>(null);
  useHeight(top, useQuery(LOW).value ? null : '--top');
  return (
    <header class="top" ref={top}>
      <StatusStrip {...props} hash={location.hash} />
      {session.recognition.tells.value && recognized}
      <NextFlightNotes session={session} />
      <UnfinishedBand {...{ session, write, memories }} onKeep={() => follow.keep()} />
      {!staged && (
        <>
          <LinkNotice session={session} platform={platform} onStop={() => void leaving.disconnect()} />
          <JobProgress runner={session.runner} />
        </>
      )}
      <NoticeBar {...props} />
    </header>
  );
}

const SAID_HERE: ReadonlySet<JobKind> = new Set(['read', 'select', 'look', 'memories']);

/** They have selected another memory, and first go back when they are asked to stop. */
const GOES_BACK: ReadonlySet<JobKind> = new Set(['look', 'memories']);

function JobProgress({ runner }: { readonly runner: JobRunner }) {
  const { program, write } = messages.value;
  const job = runner.job.value;
  // Other jobs are shown where they were begun.
  if (!job || !SAID_HERE.has(job.kind) || runner.claimed.value) return null;
  const memory = job.memory ?? job.progress?.memory ?? null;
  const reading = memory === null ? program.reading : `${write.stages.read} ${memoryName(memory)}`;
  return (
    <ProgressLine
      label={job.kind === 'select' ? program.selecting : reading}
      progress={job.progress}
      stopping={job.stopping ? (GOES_BACK.has(job.kind) ? write.stoppingBack : write.stopping) : null}
      onStop={() => void runner.stop()}
    />
  );
}
