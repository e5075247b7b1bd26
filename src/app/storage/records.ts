import * as v from 'valibot';
import {
  type Model,
  requireFlight,
  requireModel,
  requireSetting,
  type ServoUse,
  sameLayout,
  type TimerProgram,
} from '../../program/index.js';
import { type Identity, MAX_TIME, requireIdentity, slotCount } from '../../protocol/index.js';
import type { Content } from '../editing/content.js';
import { type History, MAX_STEPS, STEP_CODES } from '../editing/history.js';
import { withPresentNames } from './former-names.js';

/*
 * What is stored is checked as strictly as what comes over a wire: an error of another version, of the browser or of a
 * disk must not become a value that somebody writes to a timer.
 */

const whole = (min: number, max: number) => v.pipe(v.number(), v.safeInteger(), v.minValue(min), v.maxValue(max));
/** Milliseconds since 1970, as far as a calendar goes. */
const date = v.pipe(v.number(), v.finite(), v.minValue(0), v.maxValue(8.64e15));
const key = v.pipe(v.string(), v.maxLength(200));
/** The number of a tab, see `TabNumber`. */
const tab = v.pipe(v.number(), v.safeInteger(), v.minValue(1));

const identity: v.GenericSchema<unknown, Identity> = v.pipe(
  v.object({
    timerClass: v.string(),
    firmware: v.string(),
    functions: v.number(),
    memories: v.number(),
    servos: v.number(),
  }),
  v.check((value) => {
    try {
      requireIdentity(value);
      return true;
    } catch {
      return false;
    }
  }, 'no timer says this of itself'),
);

interface Ranges {
  readonly time: readonly [number, number];
  readonly position: readonly [number, number];
  readonly throttle: readonly [number, number];
}
/** What a timer can say. */
const HELD: Ranges = { time: [0, MAX_TIME], position: [0, 255], throttle: [0, 255] };
/** What can be typed, and is then refused for what it is: it is kept until it is put right. */
const TYPED: Ranges = { time: [-1e9, 1e9], position: [-999_999, 999_999], throttle: [-999_999, 999_999] };

const programIn = ({ time, position, throttle }: Ranges): v.GenericSchema<unknown, TimerProgram> =>
  v.pipe(
    v.object({
      identity,
      memory: v.nullable(whole(0, 254)),
      times: v.array(whole(...time)),
      positions: v.array(v.array(whole(...position))),
      idleThrottle: v.nullable(whole(...throttle)),
    }),
    v.check(({ identity: of, memory, times, positions }) => {
      const slots = slotCount(of);
      const fits =
        times.length === slots && positions.length === of.servos && positions.every((row) => row.length === slots);
      return fits && (memory === null || memory < of.memories);
    }, 'the lists do not have the shape of the identity'),
  );
const held = programIn(HELD);
const wanted = programIn(TYPED);

const texts = v.pipe(
  v.record(v.pipe(v.string(), v.maxLength(100)), v.pipe(v.string(), v.maxLength(10_000))),
  v.check((found) => Object.keys(found).length <= 1000, 'more texts than fields'),
);
const params = v.pipe(
  v.record(
    v.pipe(v.string(), v.maxLength(100)),
    v.union([v.pipe(v.string(), v.maxLength(100)), v.pipe(v.number(), v.safeInteger())]),
  ),
  v.check((found) => Object.keys(found).length <= 20, 'more than a name says'),
);
/** The setting that a program belongs to. One that cannot be read is no reason to lose what was typed. */
const of = v.optional(v.fallback(v.optional(v.object({ id: key, saved: held })), undefined));
const backupOf = v.optional(v.fallback(v.optional(key), undefined));
const steps = v.pipe(
  v.array(
    v.object({
      name: v.object({ code: v.picklist(STEP_CODES), params }),
      state: v.object({ working: wanted, texts, of, backupOf }),
    }),
  ),
  v.maxLength(MAX_STEPS),
);
const history: v.GenericSchema<unknown, History<Content>> = v.object({
  past: steps,
  future: steps,
  open: v.nullable(v.pipe(v.string(), v.maxLength(200))),
});

/** What a pilot was working on, under the kind of timer and the memory that it is for. */
export const draftSchema = v.pipe(
  v.object({
    key,
    /** What the timer held when the work began. */
    baseline: held,
    working: wanted,
    /** Texts in fields that are no values yet, by field. */
    texts,
    of,
    backupOf,
    /**
     * What can be undone and redone; older drafts have none. One that cannot be read is no reason to lose the draft.
     */
    history: v.optional(v.fallback(v.optional(history), undefined)),
    /** Milliseconds since 1970. */
    savedAt: date,
    /** When the baseline was read, in milliseconds since 1970; older drafts do not say. */
    readAt: v.optional(v.nullable(date)),
    /** When it was made, for a program that was read from no timer, in milliseconds since 1970. */
    madeAt: v.exactOptional(date),
    /** A program that was made here and is put away: it does not come to the screen by itself any more. */
    shelved: v.exactOptional(v.boolean()),
    /** Whether it came from the simulated timer. */
    simulated: v.boolean(),
    /** The model that it is for, by its id; absent where that is not known. */
    model: v.exactOptional(key),
    /** The number of the tab that it was worked on in, see `TabNumber`. */
    tab: v.optional(tab, 1),
  }),
  v.check(({ baseline, working }) => sameLayout(baseline.identity, working.identity), 'the two are not of one layout'),
);
export type Draft = v.InferOutput<typeof draftSchema>;

/**
 * A job that has begun to change a timer, kept from before its first byte until its end was seen. A write, under the
 * kind of timer and the memory that it is for; or a memory round trip, under the kind alone.
 */
export const unfinishedSchema = v.variant('kind', [
  v.pipe(
    v.object({
      kind: v.literal('write'),
      key,
      startedAt: date,
      /** What the timer held by the last reading before. */
      before: held,
      /** What it was to hold. */
      goal: held,
      /** When `before` was read, in milliseconds since 1970; older records do not say. */
      readAt: v.optional(v.nullable(date), null),
      /** When a fresh reading explained what the timer holds: from then on only the offer to finish it is left. */
      seenAt: v.optional(v.nullable(date), null),
      /** The number of the tab in which it is under way, see `TabNumber`; null when that has seen its end. */
      tab: v.optional(v.nullable(tab), null),
    }),
    v.check(({ before, goal }) => sameLayout(before.identity, goal.identity), 'the two are not of one layout'),
  ),
  v.object({
    kind: v.literal('memories'),
    key,
    startedAt: date,
    identity,
    /** The memory that was current, and is to be current again; counted from 0. */
    original: whole(0, 254),
  }),
]);
export type Unfinished = v.InferOutput<typeof unfinishedSchema>;
export type UnfinishedWrite = Extract<Unfinished, { kind: 'write' }>;
export type UnfinishedRoundTrip = Extract<Unfinished, { kind: 'memories' }>;

/** What one memory of a timer held at a time: before a write, or when the pilot asked for it. */
export const backupSchema = v.object({
  /** Sorts by time. */
  key,
  savedAt: date,
  reason: v.picklist(['write', 'memories']),
  program: held,
  simulated: v.boolean(),
  /** The model whose timer it was, by its id; absent where that was not known. */
  model: v.exactOptional(key),
});
export type Backup = v.InferOutput<typeof backupSchema>;

/** What one function of the program room takes for what it says. */
const checked = <T>(require: (value: unknown) => T): v.GenericSchema<unknown, T> =>
  v.pipe(
    v.unknown(),
    v.rawTransform(({ dataset, addIssue, NEVER }) => {
      try {
        return require(dataset.value);
      } catch (cause) {
        addIssue({ message: cause instanceof Error ? cause.message : String(cause) });
        return NEVER;
      }
    }),
  );
/** Until now nobody looked whether the ends of a servo stand in order: a model from a file may have them otherwise. */
function withEndsInOrder(model: unknown): unknown {
  const { servos } = { ...(model as Partial<Model> | null) };
  if (!Array.isArray(servos) || !servos.some((use: Partial<ServoUse> | null) => isTurned(use))) return model;
  return {
    ...(model as Model),
    servos: servos.map((use: ServoUse) => (isTurned(use) ? { ...use, low: use.high, high: use.low } : use)),
  };
}

function isTurned(use: Partial<ServoUse> | null): boolean {
  const { low, high } = { ...use };
  return typeof low === 'number' && typeof high === 'number' && low > high;
}

/** The place in the order that the pilot has given: smaller comes first. */
const order = v.pipe(v.number(), v.finite());

/** A model of the library, under its id. */
export const modelSchema = v.object({
  key,
  model: v.pipe(v.unknown(), v.transform(withEndsInOrder), checked(requireModel)),
  order,
  /** Milliseconds since 1970. */
  changedAt: date,
  /** What the memories of its timer held when they were last seen to be verified, each once. */
  verified: v.pipe(
    v.array(
      v.object({ program: held, at: date, /** Of a simulated timer. */ simulated: v.exactOptional(v.boolean()) }),
    ),
    v.maxLength(255),
  ),
});
export type ModelRecord = v.InferOutput<typeof modelSchema>;

/** A setting of the library, under its id. */
export const settingSchema = v.object({ key, setting: checked(requireSetting), order, changedAt: date });
export type SettingRecord = v.InferOutput<typeof settingSchema>;

/** A flight of the log, under its id. */
export const flightSchema = v.object({ key, flight: checked(requireFlight), changedAt: date });
export type FlightRecord = v.InferOutput<typeof flightSchema>;

/** What was tried on the bench and is neither kept nor put back yet, under the kind of timer and the memory. */
export const trialsSchema = v.pipe(
  v.unknown(),
  v.transform(withPresentNames),
  v.array(v.object({ key, before: held, touched: v.array(v.string()) })),
);

/** What is remembered of a port. Two adapters of one make share it: nothing tells them apart. */
export const portSchema = v.object({
  key,
  usedAt: date,
  settings: v.object({
    baudRate: v.union([v.literal('find'), whole(1, 100_000_000)]),
    dataBits: v.picklist([7, 8]),
    parity: v.picklist(['none', 'even', 'odd']),
    stopBits: v.picklist([1, 2]),
    dtr: v.nullable(v.boolean()),
    rts: v.nullable(v.boolean()),
  }),
  /** The rate at which a timer answered last; null when none has. */
  foundRate: v.nullable(whole(1, 100_000_000)),
  /** What was assumed of the timers at this port, by kind of timer: a first guess for the next one. */
  quirks: v.record(
    v.string(),
    v.object({
      bigEndianTimes: v.exactOptional(v.boolean()),
      servoFirst: v.exactOptional(v.boolean()),
      memoriesFromOne: v.exactOptional(v.boolean()),
      bareChecksumRequests: v.exactOptional(v.boolean()),
      positionsNeedMove: v.exactOptional(v.boolean()),
    }),
  ),
});
export type PortRecord = v.InferOutput<typeof portSchema>;

/**
 * What was stored and cannot be read, as it was found: it may matter to somebody, and a later version may be able to
 * read it.
 */
export const asideSchema = v.object({
  key: v.pipe(v.string(), v.maxLength(1000)),
  /** Where it lay. */
  shelf: v.pipe(v.string(), v.maxLength(100)),
  /** When it was set aside, in milliseconds since 1970. */
  at: date,
  stored: v.unknown(),
});
export type AsideRecord = v.InferOutput<typeof asideSchema>;
