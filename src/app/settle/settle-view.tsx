import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { doneText } from '../bench/bench-text.js';
import { saveFile } from '../browser/save-file.js';
import { dotted } from '../messages/dotted.js';
import { dtText, fieldName, messages, momentText, slotInSentence, slotLabel } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import { settledTexts } from '../messages/settled-text.js';
import { BackHead } from '../ui/back-head.js';
import { Check } from '../ui/check.js';
import { HoldButton } from '../ui/hold-button.js';
import { ProgressLine } from '../ui/progress-line.js';
import type { Session } from '../work/session.js';
import { choicesOf, type Said, type Seen } from './conclusions.js';
import type { Settle } from './settle.js';
import type { Step } from './steps.js';
import './settle-view.css';

/** Where the file is welcome. */
const FORM = 'https://github.com/sidus-timer/sidus-timer/issues/new?template=capture.yml';

interface SettleViewProps {
  readonly session: Session;
  readonly settle: Settle;
  /** The whole line as a file, with these lines above it. */
  readonly recording: (notes: readonly string[]) => string;
  /** Stands in place of the walk while no timer is connected. */
  readonly connect: ComponentChildren;
}

/** The walk through the open questions: the present step, and what is settled. */
export function SettleView({ session, settle, recording, connect }: SettleViewProps) {
  const { views, previous, next } = messages.value;
  const { settle: words } = moreMessages.value;
  const at = settle.at.value;
  const step = settle.step.value;
  const steps = settle.steps.value;
  const job = session.runner.job.value;
  const heading = useRef<HTMLHeadingElement>(null);
  const shown = useRef(at);
  useLayoutEffect(() => {
    // The button that was pressed has gone.
    if (shown.current !== at) heading.current?.focus();
    shown.current = at;
  }, [at]);
  const seen = settle.seen.value;
  return (
    <div class="stack gap-4 settle">
      <BackHead back={views.names.settings} to="#settings">
        {words.title}
      </BackHead>
      <p>{words.lead}</p>
      {session.connection.value ? (
        <Check checked={settle.isSafe.value} onChange={(isSafe) => settle.saySafe(isSafe)}>
          {words.safe}
        </Check>
      ) : (
        <div class="buttons">{connect}</div>
      )}
      {settle.isBlocked.value && !job && <p class="bad-text">{words.blocked}</p>}
      <section class="stack gap-3 panel settle-step" key={step.name}>
        <h2 ref={heading} tabIndex={-1}>
          {`${at + 1} / ${steps.length} · ${headOf(step)}`}
        </h2>
        <StepBody settle={settle} step={step} session={session} recording={recording} />
        {job?.kind === 'write' && (
          <ProgressLine label={words.tryIt} progress={job.progress} onStop={() => void session.runner.stop()} />
        )}
        {seen && (
          <div class="buttons">
            <button type="button" class="quiet" disabled={at === 0 || job !== null} onClick={() => settle.back()}>
              {previous}
            </button>
            <button
              type="button"
              class="quiet"
              disabled={at === steps.length - 1 || job !== null}
              onClick={() => settle.next()}
            >
              {next}
            </button>
          </div>
        )}
      </section>
      {seen && (
        <dl class="ruled settle-list">
          {settledTexts(settle.answers.value, seen.identity.timerClass).map(([name, text]) => (
            <div class="row between" key={name}>
              <dt>{name}</dt>
              <dd class={text === null ? 'hint' : ''}>{text ?? words.open}</dd>
            </div>
          ))}
        </dl>
      )}
    </div>
  );
}

function headOf({ name }: Step): string {
  const { settle: words } = moreMessages.value;
  if (name === 'read') return words.readIt;
  if (name === 'times' || name === 'memory') return words.which;
  if (name === 'count') return `${words.names.count}?`;
  if (name === 'zeros' || name === 'unlock') return words.names[name];
  return name === 'end' ? messages.value.done : words.tryIt;
}

type BodyProps = Pick<SettleViewProps, 'session' | 'settle' | 'recording'> & { readonly step: Step };

function StepBody({ session, settle, step, recording }: BodyProps) {
  const { bench: benchWords, save } = messages.value;
  const { settle: words } = moreMessages.value;
  const { bench } = settle;
  const seen = settle.seen.value;
  const disabled = !settle.ready.value;
  const identity = seen?.identity;
  const slot = settle.slot;
  const stands = slot === null || bench.stand.at.value === slot;
  const act = (): void => void settle.act();
  const done = bench.done.value;
  return (
    <>
      {step.act === 'try' && <p>{words.tryHint}</p>}
      {step.moves && <p class="bad-text">{words.danger}</p>}
      {step.act === 'unlock' && (
        <p class="bad-text" id="settle-unlock">
          {benchWords.unlockHint}
        </p>
      )}
      {identity && (step.act === 'try' || done?.action.kind === 'unlock') && (
        <p role="status">{doneText(identity, done, bench.stand.at.value)}</p>
      )}
      <div class="buttons">
        {identity && slot !== null && (
          <button
            type="button"
            class={settle.isDone.value || stands ? '' : 'primary'}
            disabled={disabled}
            onClick={() => void bench.moveTo(slot)}
          >
            {benchWords.bring({ slot: slotInSentence(identity, slot) })}
          </button>
        )}
        {step.act === 'unlock' ? (
          <HoldButton
            label={benchWords.unlock}
            holding={benchWords.unlockHold}
            describedBy="settle-unlock"
            disabled={disabled}
            onHeld={act}
          />
        ) : (
          step.act && (
            <button
              type="button"
              class={settle.isDone.value || !stands ? '' : 'primary'}
              disabled={disabled || !stands}
              onClick={act}
            >
              {{ read: words.readIt, try: words.tryIt, zeros: words.ask }[step.act]}
            </button>
          )
        )}
        {seen && step.name === 'end' && (
          <button type="button" class="primary" onClick={() => saveSettled(session, settle, seen, recording)}>
            {save}
          </button>
        )}
      </div>
      {seen && step.asks && settle.isDone.value && <Question settle={settle} seen={seen} name={step.asks} />}
      {step.name === 'end' && (
        <p>
          <a class="alone" href={FORM} target="_blank" rel="noreferrer">
            {words.send}
          </a>
        </p>
      )}
    </>
  );
}

interface QuestionProps {
  readonly settle: Settle;
  readonly seen: Seen;
  readonly name: keyof Said;
}

function Question({ settle, seen, name }: QuestionProps) {
  const { settle: words } = moreMessages.value;
  const choices = choicesFor(name, seen);
  const given = JSON.stringify(settle.said.value[name]);
  return (
    <div class="stack gap-3">
      {(name === 'away' || name === 'there') && <p>{words.moved}</p>}
      <div class="buttons">
        {[...choices, { label: words.unknown, answer: null }].map(({ label, answer }) => (
          <button
            type="button"
            key={label}
            aria-pressed={answer !== null && JSON.stringify(answer) === given}
            onClick={() => settle.answer(name, answer)}
          >
            {label}
          </button>
        ))}
      </div>
    </div>
  );
}

/** The answers to choose from, with what each looks like. */
function choicesFor(name: keyof Said, { identity, times }: Seen): { label: string; answer: Said[typeof name] }[] {
  const { functions, memories } = identity;
  if (name === 'times') {
    // One from the middle, and DT.
    const slot = Math.floor(functions / 2);
    return choicesOf([times[slot] as number, times[functions] as number]).map(({ ways, shown: [one, dt] }) => ({
      label: dotted([
        slot > 0 && `${slotLabel(identity, slot)} ${momentText(one as number)}`,
        `${fieldName(identity, { kind: 'time', slot: functions })} ${dtText(dt as number)}`,
      ]),
      answer: ways,
    }));
  }
  if (name === 'memory') {
    return Array.from({ length: memories }, (_, memory) => ({ label: memoryName(memory), answer: memory + 1 }));
  }
  const [yes, no] = name === 'count' ? (['launch', 'previous'] as const) : [true, false];
  return [
    { label: moreMessages.value.settle.yes, answer: yes },
    { label: moreMessages.value.settle.no, answer: no },
  ];
}

/** Answers and line in one file, without any name of a model, a place or a person. */
function saveSettled(session: Session, settle: Settle, seen: Seen, recording: SettleViewProps['recording']): void {
  const { open } = moreMessages.value.settle;
  const { timerClass, firmware } = seen.identity;
  const notes = settledTexts(settle.answers.value, timerClass).map(([name, text]) => `${name}: ${text ?? open}`);
  const simulated = session.link.simulated.value ? [messages.value.header.simulated] : [];
  // The letter of a class may be any printable character.
  const kind = `${timerClass}${firmware}`.replaceAll(/[^a-z0-9]/gi, '_');
  saveFile(`sidus-settled-${kind}.txt`, recording([...simulated, ...notes, FORM]));
}
