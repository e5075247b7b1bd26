import type { Model, TimerProgram } from '../../program/index.js';
import { slotCount } from '../../protocol/index.js';
import { isOfOneShape } from '../editing/shape.js';

/*
 * Nothing on the wire names a timer, but the content of its memories can. The rule: 1. A model is compared with timers
 * of one class, firmware and layout only, and memory by memory: what was read of M2 with what M2 of the model held when
 * that was last seen. 2. A memory is *like* the model's when at most a tenth of its values differ: four of 44. That
 * leaves room for what a pilot sets with another programmer on the field (DT, motor stop, a trim or two) and for no
 * more. One memory that differs in more values excludes the model. 3. A memory *names* the model that it is nearest to,
 * and with it every model that is about as near: that differs in at most twice as many values. DT, motor stop and idle
 * throttle do not count here: they are changed every day and tell nothing about a model. So models with equal trims are
 * named together. 4. A memory names nobody when what it holds is common: where no servo moves, or all move in equal
 * steps, as in a timer that is new; or where it is as near to a template as to the model. 5. The timer is of the one
 * model that all memories name, if each of them names somebody or none. Where they do not agree on one, all that were
 * named are candidates, and the pilot is asked.
 */

/** What one memory of a model's timer held when it was last seen to be verified. */
export interface HeldOnce {
  readonly program: TimerProgram;
  /** Milliseconds since 1970. */
  readonly at: number;
}

/** A model, as far as the rule looks at it. */
export interface ModelHeld {
  readonly model: Model;
  /** Each memory at most once. */
  readonly verified: readonly HeldOnce[];
}

/** A model that what was read may belong to. */
export interface Candidate {
  readonly model: Model;
  /** How many values differ, over the memories that were compared. */
  readonly differs: number;
  /** When what it was compared with was last seen, in milliseconds since 1970: the latest of them. */
  readonly at: number;
}

/** Which model the timer belongs to, by what it holds. */
export type Recognised =
  /** `same`: it holds what it held then. `like`: some values differ. */
  | { readonly kind: 'same' | 'like'; readonly model: Model; readonly of: Candidate }
  /** It may be any of these, two or more; the nearest first. */
  | { readonly kind: 'several'; readonly candidates: readonly Candidate[] }
  /** Nobody is named. It is like these in some memory; the nearest first, after them those that are excluded. */
  | { readonly kind: 'unknown'; readonly candidates: readonly Candidate[] };

/** One value in this many may differ in a memory that is like another. */
const LIKE = 10;
/** A model in which up to this many times as many values differ is about as near. */
const ABOUT_AS_NEAR = 2;

/** In how many values two contents of one layout differ. */
interface Distance {
  /** Positions, and the times of the functions. */
  readonly trim: number;
  /** All that is known of both. */
  readonly all: number;
}

/** A memory of a model beside the one that was read. */
interface Compared {
  readonly model: Model;
  readonly distance: Distance;
  readonly at: number;
  /** Whether what was read is nearer to it than to anything common. */
  readonly tells: boolean;
}

/**
 * Finds the model of a timer: see the rule above.
 * @param read what was read of its memories, each at most once; all of one timer.
 * @param models all that are known.
 * @param templates what any timer of any model may hold, of whatever layout.
 */
export function recognise(
  read: readonly TimerProgram[],
  models: readonly ModelHeld[],
  templates: readonly TimerProgram[],
): Recognised {
  const memories = read.map((program) => comparedWith(program, models, templates));
  const excluded = new Set(memories.flatMap(({ other }) => other));
  const left = memories.map(({ like }) => like.filter(({ model }) => !excluded.has(model.id)));
  const named = left.map(nearest).filter((ids) => ids.size > 0);
  const candidates = candidatesOf(left);
  if (named.length === 0) {
    const rest = candidatesOf(memories.map(({ like }) => like.filter(({ model }) => excluded.has(model.id))));
    return { kind: 'unknown', candidates: [...candidates, ...rest] };
  }
  const [one, ...more] = candidates.filter(({ model }) => named.every((ids) => ids.has(model.id)));
  if (one && more.length === 0) return { kind: one.differs === 0 ? 'same' : 'like', model: one.model, of: one };
  return { kind: 'several', candidates: candidates.filter(({ model }) => named.some((ids) => ids.has(model.id))) };
}

/** One memory beside those of all models: which of them are like it, and which are not. */
function comparedWith(
  read: TimerProgram,
  models: readonly ModelHeld[],
  templates: readonly TimerProgram[],
): { like: Compared[]; other: string[] } {
  const toCommon = isPlain(read)
    ? 0
    : Math.min(
        ...templates
          .filter((template) => isOfOneShape(template.identity, read.identity))
          .map((template) => distanceOf(template, read).trim),
      );
  const limit = limitOf(read);
  const like: Compared[] = [];
  const other: string[] = [];
  for (const { model, verified } of models) {
    const held = verified.find(({ program }) => isComparable(program, read));
    if (!held) continue;
    const distance = distanceOf(held.program, read);
    if (distance.all > limit) other.push(model.id);
    else like.push({ model, distance, at: held.at, tells: distance.trim < toCommon });
  }
  return { like, other };
}

/** The ids of the models that a memory names. */
function nearest(like: readonly Compared[]): ReadonlySet<string> {
  const telling = like.filter(({ tells }) => tells).map(({ distance }) => distance.trim);
  if (telling.length === 0) return new Set();
  const most = Math.min(...telling) * ABOUT_AS_NEAR;
  return new Set(like.filter(({ distance }) => distance.trim <= most).map(({ model }) => model.id));
}

/** Each model that is like some of the memories, and unlike none; the nearest first. */
function candidatesOf(memories: readonly (readonly Compared[])[]): Candidate[] {
  const all = new Map<string, Candidate & { compared: number }>();
  for (const { model, distance, at } of memories.flat()) {
    const before = all.get(model.id) ?? { model, differs: 0, at: 0, compared: 0 };
    all.set(model.id, {
      model,
      differs: before.differs + distance.all,
      at: Math.max(before.at, at),
      compared: before.compared + 1,
    });
  }
  return [...all.values()]
    .sort((a, b) => b.compared - a.compared || a.differs - b.differs || b.at - a.at)
    .map(({ model, differs, at }) => ({ model, differs, at }));
}

/** Of one memory of timers of one class, firmware and layout. */
function isComparable(a: TimerProgram, b: TimerProgram): boolean {
  return (
    a.memory === b.memory &&
    a.identity.firmware === b.identity.firmware &&
    a.identity.memories === b.identity.memories &&
    isOfOneShape(a.identity, b.identity)
  );
}

function limitOf({ identity }: TimerProgram): number {
  return Math.floor((slotCount(identity) * (1 + identity.servos)) / LIKE);
}

/** Both have one layout. An idle throttle that is not known of one of them is none of its values. */
function distanceOf(a: TimerProgram, b: TimerProgram): Distance {
  const { functions, timerClass } = a.identity;
  let trim = 0;
  let daily = 0;
  for (const [slot, time] of a.times.entries()) {
    if (time === b.times[slot]) continue;
    if (slot === functions || (slot === 0 && timerClass === 'Q')) daily++;
    else trim++;
  }
  for (const [servo, row] of a.positions.entries()) {
    const other = b.positions[servo];
    for (const [slot, position] of row.entries()) if (position !== other?.[slot]) trim++;
  }
  if (a.idleThrottle !== null && b.idleThrottle !== null && a.idleThrottle !== b.idleThrottle) daily++;
  return { trim, all: trim + daily };
}

/** Whether each servo goes in equal steps, or stands still: nobody has trimmed that. */
function isPlain({ positions }: TimerProgram): boolean {
  return positions.every((row) => {
    const step = (row[1] ?? 0) - (row[0] ?? 0);
    return row.every((position, slot) => slot === 0 || position - (row[slot - 1] ?? 0) === step);
  });
}
