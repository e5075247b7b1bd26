import { type Change, fieldKey, type PartOfWrite } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { changeText, fieldInSentence, figureText, messages } from '../messages/index.js';
import { keyFields } from '../messages/key-figures.js';
import { memoryName, timerName } from '../messages/names.js';
import type { UnfinishedRoundTrip, UnfinishedWrite } from '../storage/index.js';
import { isSimulated } from '../timer/knowledge.js';
import { openValues } from '../timer/known.js';
import type { NextFlightWord } from '../timer/next-flight.js';
import { kindKey } from '../timer/record-keys.js';
import type { OpenTrial } from '../timer/trials.js';
import { memoryOf, memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import type { OpenJob } from '../work/unfinished-work.js';

/** How many values are named when neither DT nor the motor stop is among them. */
const NAMED = 2;

/** How many tried positions are named. */
const NAMED_TRIED = 3;

/** Which memory of which timer something unfinished is about. */
export interface Where {
  /** The key of its record. */
  readonly key: string;
  readonly identity: Identity;
  /** The memory to read, counted from 0; null for the current one. */
  readonly memory: number | null;
}

export function whereOf(one: UnfinishedWrite | UnfinishedRoundTrip | OpenTrial): Where {
  const { key } = one;
  if ('before' in one) return { key, identity: one.before.identity, memory: one.before.memory };
  return { key, identity: one.identity, memory: null };
}

/** Whether the connected timer may be that timer: it is of the same kind, and the pilot has not said otherwise. */
export function isHere(session: Session, where: Where): boolean {
  return isLikeConnected(session, where) && !session.knowledge.isOfOther(where.key);
}

export function isOfKind(where: Where, identity: Identity, simulated: boolean): boolean {
  return kindKey(where.identity, isSimulated(where)) === kindKey(identity, simulated);
}

/** What the worst of all that is unfinished is, in one sentence; null for what is no danger to a flight. */
export function graveText(session: Session, job: OpenJob): string | null {
  if (job.kind === 'uncertain') return uncertainText(job.record, otherTimer(session, whereOf(job.record)));
  if (job.kind === 'left') return leftText(session, job.record);
  if (job.kind !== 'flight') return null;
  return nextFlightText(session, job.word, session.connection.value ? 'now' : 'last');
}

/** How far an interrupted write came, by a reading. */
export function extentText({ extent, written, missing, foreign }: PartOfWrite): string {
  const { recovery: words, notes, edits } = messages.value;
  return {
    nothing: words.nothing({ missing: missing.length }),
    part: words.part({ values: edits.cells({ count: written.length }), missing: missing.length }),
    foreign: words.foreign({ count: foreign.length }),
    all: notes['write-completed'].advice,
  }[extent];
}

/** “Tried: Function 4, S2: 55 → 70.” */
export function triedText(identity: Identity, tried: readonly Change[]): string {
  const named = tried.slice(0, NAMED_TRIED).map((change) => changeText(identity, change));
  return messages.value.bench.triedHere({ named: named.join('; '), more: tried.length - named.length });
}

/** “Positions were tried in M1 of the F1Q 536.” */
export function triedElsewhere(session: Session, trial: OpenTrial): string {
  return messages.value.bench.triedIn({ memory: placeText(session, whereOf(trial), trial.before.memory) });
}

/** “M3 of the F1Q 536 may fly next: selecting it was interrupted.” */
function leftText(session: Session, record: UnfinishedRoundTrip): string {
  const { recovery: words } = messages.value;
  const where = whereOf(record);
  if (record.job === 'look' || record.job === 'select')
    return words.mayFly({ memory: placeText(session, where, record.memory ?? null) });
  return words.mayNotFly({ original: placeText(session, where, record.original) });
}

function placeText(session: Session, where: Where, memory: number | null): string {
  const timer = otherTimer(session, where);
  const name = memoryOf(null, memory);
  return timer === null ? name : messages.value.knowledge.memoryOf({ memory: name, timer });
}

/** The name of a timer that is not the connected one; null for that one. */
function otherTimer(session: Session, where: Where): string | null {
  const { timer, otherTimer: another } = messages.value.knowledge;
  if (isHere(session, where)) return null;
  const { identity } = where;
  const said = isLikeConnected(session, where) ? another : timer;
  return said[isSimulated(where) ? 'simulated' : 'here']({ name: timerName(identity), firmware: identity.firmware });
}

function isLikeConnected({ connection, link }: Session, where: Where): boolean {
  return connection.value !== null && isOfKind(where, connection.value.identity, link.simulated.value);
}

/** “DT is 3:00 min or 6:00 min, and 2 more values are not certain”. @param more how many further values there are. */
export function valuesText([first = '', ...others]: readonly string[], more: number): string {
  const { knowledge: words } = messages.value;
  if (more > 0) return words.list({ named: [first, ...others].join(', '), more });
  return others.reduce((before, next) => words.and({ first: before, next }), first);
}

/**
 * “It is not known what M1 holds: DT is 3:00 min or 6:00 min. Do not fly before it is read.”
 * @param timer null for the connected one.
 */
export function uncertainText(one: UnfinishedWrite, timer: string | null): string {
  const { knowledge: words } = messages.value;
  const { identity, memory } = one.before;
  const open = openValues(one);
  const keys = keyFields(identity).map(fieldKey);
  const keyed = open.filter(({ field }) => keys.includes(fieldKey(field)));
  const named = keyed.length > 0 ? keyed : open.slice(0, NAMED);
  const values = named.map(({ field, from, to }) => {
    return words.either({
      name: fieldInSentence(identity, field),
      before: figureText(identity, field, from),
      goal: figureText(identity, field, to),
    });
  });
  const name = memory === null ? words.thisMemory : memoryName(memory);
  const where = timer === null ? name : words.memoryOf({ memory: name, timer });
  return `${words.uncertain({ memory: where, values: valuesText(values, open.length - named.length) })} ${words.noFly}`;
}

/**
 * Says that another memory than the one that is meant flies next, or that nobody knows which.
 * @param when `now`: what the timer says. `last`: what it said before the connection was lost.
 */
export function nextFlightText(session: Session, word: NextFlightWord, when: 'now' | 'last'): string {
  const { nextFlight: words } = messages.value;
  const nameOf = (memory: number): string => memoryText(session, memory);
  const said =
    word.code === 'other'
      ? [{ now: words.other, last: words.last }[when]({ memory: nameOf(word.memory) })]
      : [words.unknown, ...(word.asked === null ? [] : [words.asked({ memory: nameOf(word.asked) })])];
  const came = session.nextFlight.came.value;
  return [...said, came === null ? words.originalUnknown : words.original({ original: nameOf(came) })].join(' ');
}
