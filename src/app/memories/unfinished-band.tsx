import { useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { setValues } from '../editing/edit.js';
import { dateText, messages } from '../messages/index.js';
import { isSimulated } from '../session/knowledge.js';
import { memoryText } from '../session/memory-names.js';
import type { Session } from '../session/session.js';
import type { OpenTrial } from '../session/trials.js';
import type { OpenJob } from '../session/unfinished-work.js';
import { graveText, isHere, triedElsewhere, triedText, type Where, whereOf } from '../write/unfinished-text.js';
import type { WriteJob } from '../write/write-job.js';
import { Recovery } from './recovery-panel.js';
import '../write/unfinished-band.css';

interface UnfinishedProps {
  readonly session: Session;
  readonly write: WriteJob;
  /** Reads a memory that is not current. */
  readonly onLook: (memory: number) => void;
  /** Makes a memory fly next. */
  readonly onFly: (memory: number) => void;
  /** Keeps the positions that were tried in the connected timer. */
  readonly onKeep: () => void;
}

/**
 * What is unfinished, in every view, until a reading or the pilot settles it: one band, the worst first, the rest
 * behind it.
 */
export function UnfinishedBand(props: UnfinishedProps) {
  const { recovery: words } = messages.value;
  const isOpen = useSignal(false);
  // What can be done about a write waits while the dialog of another one is open.
  const isWriting = props.write.current.value !== null;
  const jobs = props.session.unfinished.value.filter(
    ({ kind }) => !isWriting || (kind !== 'offer' && kind !== 'tried'),
  );
  if (jobs.length === 0) return null;
  const shown = isOpen.value ? jobs : jobs.slice(0, 1);
  return (
    <div class="unfinished" aria-live="assertive">
      {shown.map((job) => (
        <Unfinished key={job.key} {...props} job={job} />
      ))}
      {jobs.length > 1 && (
        <p class="unfinished-more">
          <button
            type="button"
            class="quiet"
            aria-expanded={isOpen.value}
            onClick={() => (isOpen.value = !isOpen.value)}
          >
            {words.more(jobs.length - 1)}
          </button>
        </p>
      )}
    </div>
  );
}

interface JobProps extends UnfinishedProps {
  readonly job: OpenJob;
}

function Unfinished({ job, ...props }: JobProps) {
  const { session, write, onFly } = props;
  const { knowledge: words, nextFlight } = messages.value;
  const said = graveText(session, job);
  if (job.kind === 'offer') return <Recovery session={session} write={write} offer={job.offer} />;
  if (job.kind === 'tried') return <Tried {...props} trial={job.trial} />;
  if (job.kind === 'flight') {
    const { original } = job.word;
    return (
      <section class="uncertain" role="alert" aria-label={words.title}>
        <p key={said}>
          <strong>{said}</strong>
        </p>
        {original !== null && session.connection.value && (
          <div class="buttons">
            <button type="button" onClick={() => onFly(original)}>
              {nextFlight.back(memoryText(session, original))}
            </button>
          </div>
        )}
      </section>
    );
  }
  const { startedAt } = job.record;
  const offer = job.kind === 'uncertain' ? job.offer : null;
  return (
    <>
      <section class="uncertain" aria-label={words.title}>
        <p key={said}>
          <strong>{said}</strong>{' '}
          <span class="since">{job.kind === 'left' ? dateText(startedAt) : words.since(dateText(startedAt))}</span>
        </p>
        <Ways {...props} where={whereOf(job.record)} />
      </section>
      {offer && !write.current.value && <Recovery session={session} write={write} offer={offer} />}
    </>
  );
}

interface WayProps extends UnfinishedProps {
  readonly where: Where;
}

/** To read the timer, or to hear no more of it. */
function Ways(props: WayProps) {
  const { session, where } = props;
  const { knowledge: words } = messages.value;
  const asking = useSignal(false);
  const { status } = session.link.state.value;
  // While the page waits for an adapter, this would be the only button, and the wrong thing to do.
  const isSettled = status === 'off' || status === 'on';
  if (!asking.value) {
    return (
      <div class="buttons">
        <WayToRead {...props} />
        {isSettled && (
          <button type="button" class="quiet" onClick={() => (asking.value = true)}>
            {words.forget}
          </button>
        )}
      </div>
    );
  }
  return (
    <>
      <p>{words.forgetSure}</p>
      <div class="buttons">
        <button type="button" onClick={() => (asking.value = false)}>
          {messages.value.cancel}
        </button>
        <button type="button" onClick={() => void session.knowledge.forget(where.key)}>
          {words.forgetNow}
        </button>
      </div>
    </>
  );
}

/** The button that makes it certain, where that is possible from here. */
function WayToRead({ session, where, onLook }: WayProps) {
  const { knowledge: words, program, look, memoryName } = messages.value;
  const { memory } = where;
  const busy = session.runner.busy.value;
  if (isHere(session, where)) {
    const isCurrent = memory === null || session.editor.working.value?.memory === memory;
    return (
      <button type="button" disabled={busy} onClick={() => (isCurrent ? void session.reader.read() : onLook(memory))}>
        {isCurrent ? program.read : look.look(memoryName(memory))}
      </button>
    );
  }
  if (session.link.state.value.status !== 'off' || session.link.unavailable || isSimulated(where)) return null;
  return (
    <button type="button" disabled={session.engaged.value} onClick={() => void session.timer.connect()}>
      {words.connect}
    </button>
  );
}

interface TriedProps extends UnfinishedProps {
  readonly trial: OpenTrial;
}

/** Positions that were tried: to keep them, or to put back what the timer held before. */
function Tried(props: TriedProps) {
  const { session, write, trial, onFly, onKeep } = props;
  const { bench: words, look, memoryName } = messages.value;
  const where = whereOf(trial);
  const { memory } = where;
  const { trials, editor, runner } = session;
  const isNow = trials.current.value?.before === trial.before && session.connection.value !== null;
  const tried = isNow ? trials.tried.value : [];
  const said = isNow ? triedText(trial.before.identity, tried) : triedElsewhere(session, trial);
  const putBack = (): void => {
    editor.apply(setValues({ code: 'open', params: { what: 'backup' } }, trials.takeBack()));
    void write.open();
  };
  const ways: ComponentChildren = isNow ? (
    <>
      <button type="button" class="primary" onClick={onKeep}>
        {words.keep}
      </button>
      <button type="button" disabled={runner.busy.value || editor.blocked.value} onClick={putBack}>
        {words.putBack}
      </button>
    </>
  ) : (
    <>
      {memory !== null && isHere(session, where) ? (
        <button type="button" disabled={runner.busy.value} onClick={() => onFly(memory)}>
          {look.fly(memoryName(memory))}
        </button>
      ) : (
        <WayToRead {...props} where={where} />
      )}
      <button type="button" class="quiet" onClick={() => trials.forget(trial.key)}>
        {words.keep}
      </button>
    </>
  );
  return (
    <section class="recovery" aria-label={words.decide}>
      <p key={said}>
        <strong>{said}</strong> {words.decide}
      </p>
      <div class="buttons">{ways}</div>
    </section>
  );
}
