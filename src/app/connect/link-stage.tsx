import { useEffect, useRef } from 'preact/hooks';
import type { Platform } from '../browser/platform.js';
import { messages } from '../messages/index.js';
import { disturbedFor } from '../ui/progress-line.js';
import type { Session } from '../work/session.js';
import { ConnectionHelp } from './connection-help-view.js';
import { StepList } from './step-list.js';
import { NOTHING, titled, WAIT_STEPS, waitingFor } from './waiting.js';
import './link-stage.css';

interface LinkStageProps {
  readonly session: Session;
  readonly platform: Platform;
}

/** Whether the connecting takes the place of a program: there is none yet, and nothing else to look at. */
export function hasStage({ editor, engaged, link }: Session): boolean {
  return editor.identity.value === null && (engaged.value || link.state.value.status === 'closing');
}

/** Shown in place of a program while connecting: the step to take, large, until the program is there. */
export function LinkStage({ session, platform }: LinkStageProps) {
  const { header, link: words, program } = messages.value;
  const state = session.link.state.value;
  const job = session.runner.job.value;
  const seconds = session.link.waited.value;
  const waiting = waitingFor(state, seconds) ?? {
    ...NOTHING,
    said: titled(job ? program.reading : words.status.opening),
  };
  const title = useRef<HTMLHeadingElement>(null);
  // The clicked button is gone. So the focus goes to what replaced it, and a screen reader goes on from there.
  useEffect(() => {
    title.current?.focus({ preventScroll: true });
    return () => {
      if (document.activeElement === document.body) document.querySelector('main')?.focus({ preventScroll: true });
    };
  }, []);
  const progress = job?.progress ?? null;
  const share = progress && progress.total > 0 && { value: progress.done, max: progress.total };
  const left = disturbedFor(progress);
  const now = left === null ? waiting.now : messages.value.disturbed({ seconds: left });
  return (
    <section class="stack gap-4 link-stage" aria-labelledby="stage-title">
      {share ? <progress aria-label={waiting.said.title} {...share} /> : <span class="stage-ring" />}
      <div class="stack gap-4" role="status">
        <h1 id="stage-title" ref={title} tabIndex={-1}>
          {waiting.said.title}
        </h1>
        {waiting.said.advice && <p class="stage-lead">{waiting.said.advice}</p>}
      </div>
      {now && <p class="stage-lead">{now}</p>}
      {waiting.step !== null && (
        <StepList
          steps={[
            { text: words.stages.open, done: true },
            ...WAIT_STEPS.map((step) => ({ text: words.stages.steps[step], now: step === waiting.step })),
          ]}
        />
      )}
      <div class="buttons">
        {waiting.canChoose && <ChooseAnother session={session} />}
        {state.status !== 'closing' && (
          <button type="button" onClick={() => void session.timer.disconnect()}>
            {header.stop}
          </button>
        )}
      </div>
      {waiting.help && <ConnectionHelp code={waiting.help} platform={platform} link={session.link} />}
    </section>
  );
}

/** Lets the pilot choose another port, while the link goes on asking at this one. */
export function ChooseAnother({ session }: { readonly session: Session }) {
  return (
    <button type="button" onClick={() => void session.timer.chooseAnother()}>
      {messages.value.header.choosePort}
    </button>
  );
}
