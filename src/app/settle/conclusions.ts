import type { Identity } from '../../protocol/index.js';
import { ANSWERS, type Answers } from '../storage/records.js';

/** One position that was tried: what was sent, and what a reading then showed. */
export interface Tried {
  readonly servo: number;
  readonly slot: number;
  /** The order in which the request carried the two. */
  readonly order: NonNullable<Answers['layout']>;
  /** The slot at which the servos stood; null when that is not known. */
  readonly at: number | null;
  /**
   * `kept`: the position changed, and nothing else. `exchanged`: it did not, but the one with function and servo
   * exchanged did. `unchanged`: it was acknowledged, and nothing changed. `unclear`: anything else.
   */
  readonly end: 'kept' | 'exchanged' | 'unchanged' | 'unclear';
}

/** What the line has shown. */
export interface Seen {
  readonly identity: Identity;
  /** The times of the first reading, low byte first. */
  readonly times: readonly number[];
  /** The index of each reply to GETMEMORY; null where it has none. */
  readonly indices: readonly (number | null)[];
  /** How long each answer took, in milliseconds. */
  readonly delays: readonly number[];
  /** The position that was tried at another function than where the servos stand, and there. */
  readonly away: Tried | null;
  readonly there: Tried | null;
  readonly zeros: Answers['zeros'] | null;
  readonly unlock: Answers['unlock'] | null;
}

/** What the person has answered. What is not known is left out. */
export interface Said {
  /** How the times are to be read, so that they are those of the handheld: all ways that look the same. */
  readonly times?: readonly Way[];
  readonly count?: NonNullable<Answers['count']>;
  /** The number of the memory on the handheld, as people count: from 1. */
  readonly memory?: number;
  /** Whether a servo moved when a position was tried. */
  readonly away?: boolean;
  readonly there?: boolean;
}

/** A way to read a time. */
export interface Way {
  readonly order: NonNullable<Answers['order']>;
  readonly unit: NonNullable<Answers['unit']>;
}

const WAYS: readonly Way[] = ANSWERS.unit.flatMap((unit) => ANSWERS.order.map((order) => ({ unit, order })));

export function swapped(time: number): number {
  return ((time & 0xff) << 8) | (time >> 8);
}

/** What a time means, in hundredths of a second. @param time as it came, low byte first. */
function meaning(time: number, { order, unit }: Way): number {
  return (order === 'low-first' ? time : swapped(time)) * (unit === 'hundredths' ? 1 : 10);
}

/** The fewest answers from which the time of an answer is told. */
const ENOUGH = 5;

/**
 * The ways to read some times that look different, for a person to choose from. Those that look the same are one
 * choice, which settles only what they agree about.
 */
export function choicesOf(
  times: readonly number[],
): readonly { readonly ways: readonly Way[]; readonly shown: readonly number[] }[] {
  const groups = new Map<string, { ways: Way[]; shown: readonly number[] }>();
  for (const way of WAYS) {
    const shown = times.map((time) => meaning(time, way));
    const group = groups.get(String(shown)) ?? { ways: [], shown };
    group.ways.push(way);
    groups.set(String(shown), group);
  }
  return [...groups.values()];
}

/** What follows from what was seen and said. What is contradicted, unclear or unknown is left out. */
export function conclude(seen: Seen, said: Said): Answers {
  const { times = [] } = said;
  const layout = only([seen.away, seen.there].flatMap(layoutOf));
  const places = { away: placeOf(seen.away, layout), there: placeOf(seen.there, layout) };
  const found: { [Name in keyof Answers]: Answers[Name] | undefined } = {
    order: only(times.map(({ order }) => order)),
    unit: only(times.map(({ unit }) => unit)),
    count: countOf(seen, said),
    memories: memoriesOf(seen, said),
    layout,
    stores: storesOf(places),
    moves: movesOf(places, said),
    zeros: seen.zeros ?? undefined,
    unlock: seen.unlock ?? undefined,
    delay: seen.delays.length < ENOUGH ? undefined : medianOf(seen.delays),
    reserved: seen.identity.timerClass === 'Q' ? undefined : seen.times[0],
  };
  return Object.fromEntries(Object.entries(found).filter(([, answer]) => answer !== undefined)) as Answers;
}

/** What all of them are; undefined when they differ, or there are none. */
function only<T>(all: readonly T[]): T | undefined {
  return new Set(all).size === 1 ? all[0] : undefined;
}

/**
 * What is settled by an earlier walk and a later one. Answers that contradict each other settle nothing; a measure may
 * differ, and the later one counts.
 */
export function joined(before: Answers, now: Answers): Answers {
  const isSaid = (name: string): boolean => name === 'delay' || name === 'reserved';
  const both = Object.entries({ ...before, ...now }).filter(([name, answer]) => {
    const earlier = before[name as keyof Answers];
    return isSaid(name) || earlier === undefined || earlier === answer;
  });
  return Object.fromEntries(both) as Answers;
}

/** Times that count from launch rise; on Q it is certain that they do count from there. */
function countOf({ identity, times }: Seen, { count, times: ways = [] }: Said): Answers['count'] {
  if (count === 'previous') return identity.timerClass === 'Q' ? undefined : count;
  const rise = (way: Way): boolean => {
    const shown = times.slice(1).map((time) => meaning(time, way));
    return shown.every((time, at) => at === 0 || time >= (shown[at - 1] as number));
  };
  return ways.length > 0 && ways.every(rise) ? count : undefined;
}

/** Counted from 0 there is no last number, counted from 1 there is no 0. Any other number needs the handheld. */
function memoriesOf({ identity, indices }: Seen, { memory }: Said): Answers['memories'] {
  const index = indices.length < 2 ? undefined : only(indices);
  if (index === undefined) return undefined;
  if (index === null) return 'unnumbered';
  const byItself = index === 0 ? 'from-0' : index === identity.memories ? 'from-1' : undefined;
  if (memory === undefined || index > identity.memories) return byItself;
  const bySaid = memory === index + 1 ? 'from-0' : memory === index ? 'from-1' : undefined;
  return byItself === undefined || byItself === bySaid ? bySaid : undefined;
}

function layoutOf(tried: Tried | null): NonNullable<Answers['layout']>[] {
  if (tried?.end === 'kept') return [tried.order];
  if (tried?.end !== 'exchanged') return [];
  return [tried.order === 'servo-first' ? 'function-first' : 'servo-first'];
}

/** Where a timer has put a position, or should have. */
interface Place {
  readonly isKept: boolean;
  /** Whether the servos stood there. */
  readonly isThere: boolean;
}

/** Null when it is not known. @param layout an unchanged position tells something only where the request was right. */
function placeOf(tried: Tried | null, layout: Answers['layout']): Place | null {
  if (!tried || tried.at === null || tried.end === 'unclear') return null;
  if (tried.end === 'unchanged' && tried.order !== layout) return null;
  const slot = tried.end === 'exchanged' ? tried.servo : tried.slot;
  return { isKept: tried.end !== 'unchanged', isThere: tried.at === slot };
}

interface Places {
  readonly away: Place | null;
  readonly there: Place | null;
}

function storesOf({ away, there }: Places): Answers['stores'] {
  if (!away || away.isThere || (there?.isThere && !there.isKept)) return undefined;
  if (away.isKept) return 'anywhere';
  return there?.isThere ? 'there' : undefined;
}

/** Both must have been kept: nobody expects a servo to move for a position that was not. */
function movesOf({ away, there }: Places, said: Said): Answers['moves'] {
  if (!away?.isKept || away.isThere || !there?.isKept || !there.isThere) return undefined;
  if (said.away === undefined || said.there === undefined) return undefined;
  if (said.away) return said.there ? 'always' : undefined;
  return said.there ? 'there' : 'never';
}

function medianOf(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return Math.round(sorted[Math.floor(sorted.length / 2)] as number);
}
