import type { ComponentProps } from 'preact';
import { type TimerProgram, valueAt } from '../../program/index.js';
import { setValues } from '../editing/edit.js';
import { dateText, messages } from '../messages/index.js';
import { memoryName } from '../messages/names.js';
import { isSimulated } from '../timer/knowledge.js';
import type { OpenTrial } from '../timer/trials.js';
import type { Offer } from '../work/interrupted-jobs.js';
import { memoryOf, memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import type { OpenJob } from '../work/unfinished-work.js';
import {
  extentText,
  graveText,
  isHere,
  triedElsewhere,
  triedText,
  type Where,
  whereOf,
} from '../write/unfinished-text.js';
import type { ValueTable } from '../write/value-table.js';
import type { WriteJob } from '../write/write-job.js';
import { finishWrite, takeGoal } from './finish-write.js';
import type { Memories } from './memories.js';

export interface UnfinishedProps {
  readonly session: Session;
  readonly write: WriteJob;
  readonly memories: Memories;
  /** Keeps the positions that were tried in the connected timer. */
  readonly onKeep: () => void;
}

/** Something that the pilot can do about it. */
export interface Way {
  readonly label: string;
  readonly look?: 'primary' | 'quiet';
  readonly disabled?: boolean;
  readonly run?: () => void;
  /** What is asked before it is done. */
  readonly sure?: { readonly said: string; readonly label: string; readonly run: () => void };
}

/** Something unfinished, as the band shows it. */
export interface Entry {
  /** Of its region. */
  readonly name: string;
  /** Whether a flight is in danger. */
  readonly isGrave: boolean;
  readonly title: string;
  readonly said?: string;
  readonly hint?: string;
  readonly table?: Omit<ComponentProps<typeof ValueTable>, 'lastCounts'>;
  readonly ways: readonly Way[];
}

/** What is said of an unfinished job. What can be done about a write waits while the dialog of another one is open. */
export function entriesOf(props: UnfinishedProps, job: OpenJob): readonly Entry[] {
  const { session, write, memories } = props;
  const { knowledge: words, nextFlight } = messages.value;
  if (job.kind === 'offer') return [offered(props, job.offer)];
  if (job.kind === 'tried') return [tried(props, job.trial)];
  const grave = { name: words.title, isGrave: true, title: graveText(session, job) ?? '' };
  if (job.kind === 'flight') {
    const { original } = job.word;
    const canGoBack = original !== null && session.connection.value !== null;
    const back = (memory: number): Way => ({
      label: nextFlight.back({ original: memoryText(session, memory) }),
      run: () => void memories.fly(memory),
    });
    return [{ ...grave, ways: canGoBack ? [back(original)] : [] }];
  }
  const when = dateText(job.record.startedAt);
  const where = whereOf(job.record);
  const isWrite = job.kind === 'uncertain' && !job.record.tried;
  const said = isWrite ? words.since({ time: when }) : when;
  const entry: Entry = { ...grave, said, ways: [...waysToRead(props, where), ...waysToForget(session, where)] };
  const offer = job.kind === 'uncertain' && !write.current.value ? job.offer : null;
  return [entry, ...(offer ? [offered(props, offer)] : [])];
}

/** Opens a memory that need not fly next, or makes it fly next. */
function wayTo({ session, memories }: UnfinishedProps, what: 'edit' | 'fly', memory: number): Way {
  const label = messages.value.look[what]({ memory: memoryName(memory) });
  return { label, disabled: session.runner.busy.value, run: () => void memories[what](memory) };
}

/** What makes it certain, where that is possible from here. */
function waysToRead(props: UnfinishedProps, where: Where): readonly Way[] {
  const { session } = props;
  const { knowledge: words, program } = messages.value;
  const { memory } = where;
  const disabled = session.runner.busy.value;
  if (isHere(session, where)) {
    // While nobody knows which one flies next, that of the screen is taken for it.
    const { onScreen, nextFlight } = session;
    const current = nextFlight.memory.value ?? (onScreen.apart.value ? null : onScreen.memory.value);
    return memory === null || memory === current
      ? [{ label: program.read, disabled, run: () => void session.reader.read() }]
      : [wayTo(props, 'edit', memory)];
  }
  if (session.link.state.value.status !== 'off' || session.link.unavailable || isSimulated(where)) return [];
  return [{ label: words.connect, disabled: session.engaged.value, run: () => void session.timer.connect() }];
}

/** While the page waits for an adapter, this would be the only button, and the wrong thing to do. */
function waysToForget({ link, knowledge }: Session, { key }: Where): readonly Way[] {
  const { knowledge: words } = messages.value;
  if (!['off', 'on'].includes(link.state.value.status)) return [];
  const run = (): void => void knowledge.forget(key);
  return [{ label: words.forget, look: 'quiet', sure: { said: words.forgetSure, label: words.forgetNow, run } }];
}

/** What an earlier job left behind on a timer of this kind, and what can be done about it. */
function offered(props: UnfinishedProps, offer: Offer): Entry {
  const { session, write: job } = props;
  const { recovery: words, write, bench, timer } = messages.value;
  const { recovery } = session;
  const otherTimer: Way = { label: words.otherTimer, run: () => recovery.setAside() };
  const leave: Way = { label: words.leave, look: 'quiet', run: () => void recovery.settle() };
  if (offer.kind === 'elsewhere') {
    const { memory } = offer;
    const said = words.elsewhere({ memory: memoryName(memory) });
    // Where the timer does not say which memory is current, there is no way back from a look.
    const way = wayTo(props, session.nextFlight.memory.value === null ? 'fly' : 'edit', memory);
    return { name: words.title, isGrave: false, title: words.title, said, ways: [way, otherTimer, leave] };
  }
  if (offer.kind === 'memories') {
    const { title } = timer['memory-left'];
    const { original } = offer.record;
    const said = words.left({ original: memoryName(original), current: memoryOf(null, offer.current) });
    const back: Way = { ...wayTo(props, 'fly', original), look: 'primary' };
    return { name: title, isGrave: false, title, said, ways: [back, otherTimer, leave] };
  }
  const { record, part, read } = offer;
  const finish = (label: string, end: 'goal' | 'before'): Way => ({
    label,
    disabled: !session.runner.ready.value,
    run: () => void finishWrite(session, job, end),
  });
  const isForeign = part.extent === 'foreign';
  const sameTimer: Way = { ...finish(words.sameTimer, 'goal'), run: () => void takeGoal(session) };
  const before = part.extent === 'part' ? [finish(words.goBack, 'before')] : [];
  const title = record.tried ? bench.triedIn({ memory: memoryOf(null, record.goal.memory) }) : words.title;
  return {
    name: words.title,
    isGrave: false,
    title,
    said: record.tried
      ? extentText(part)
      : `${words.when({ memory: memoryOf(null, record.goal.memory), time: dateText(record.startedAt) })} ${extentText(part)}`,
    table: {
      identity: read.identity,
      names: [words.before, write.wanted, write.from],
      rows: rows(offer, read),
    },
    ...(isForeign ? {} : { hint: words.sure }),
    ways: isForeign
      ? [otherTimer, sameTimer, leave]
      : [{ ...finish(words.finish, 'goal'), look: 'primary' }, ...before, otherTimer, leave],
  };
}

/** Each value that the write was to change, or that nothing explains: before, wanted, held. */
function rows({ record: { before, goal }, part }: Extract<Offer, { kind: 'write' }>, read: TimerProgram) {
  return [...part.foreign, ...part.missing, ...part.written].map(({ field }) => ({
    field,
    values: [valueAt(before, field), valueAt(goal, field), valueAt(read, field)],
  }));
}

/** Positions that were tried: to keep them, or to put back what the timer held before. */
function tried(props: UnfinishedProps, trial: OpenTrial): Entry {
  const { session, write, onKeep } = props;
  const { bench: words } = messages.value;
  const { trials, editor, runner } = session;
  const where = whereOf(trial);
  const { memory } = where;
  const entry = { name: words.decide, isGrave: false, said: words.decide };
  // Positions are tried and put back in the memory that flies next.
  const isHeld = session.connection.value !== null && !session.onScreen.apart.value;
  if (trials.current.value?.before === trial.before && isHeld) {
    const putBack = (): void => {
      const values = trials.takeBack();
      editor.apply(setValues({ code: 'open', params: {} }, values));
      void write.open({ kind: 'edits', only: values.map(({ field }) => field) });
    };
    const ways: Way[] = [
      { label: words.keep, look: 'primary', run: onKeep },
      { label: words.putBack, disabled: runner.busy.value || editor.blocked.value, run: putBack },
    ];
    return { ...entry, title: triedText(trial.before.identity, trials.tried.value), ways };
  }
  const toIt: readonly Way[] =
    memory !== null && isHere(session, where)
      ? [wayTo(props, session.nextFlight.memory.value === memory ? 'edit' : 'fly', memory)]
      : waysToRead(props, where);
  const keep: Way = { label: words.keep, look: 'quiet', run: () => trials.forget(trial.key) };
  return { ...entry, title: triedElsewhere(session, trial), ways: [...toIt, keep] };
}
