import * as v from 'valibot';
import {
  LIMITS,
  type Model,
  requireFlight,
  requireModel,
  requireProgram,
  requireSetting,
  requireShape,
  requireVersion,
  type ServoUse,
  sameLayout,
  type TimerProgram,
} from '../../program/index.js';
import { type Identity, requireIdentity } from '../../protocol/index.js';
import type { Content } from '../editing/content.js';
import { FORMER_STEPS, type History, MAX_STEPS, STEP_CODES, type StepName } from '../editing/history.js';
import { withPresentNames } from './former-names.js';

/*
 * Stored data is checked as strictly as data from the wire: a fault of another version, of the browser or of a disk
 * must not become a value that somebody writes to a timer.
 */

const whole = (min: number, max: number) => v.pipe(v.number(), v.safeInteger(), v.minValue(min), v.maxValue(max));
/** Milliseconds since 1970, up to the latest JavaScript date. */
const date = v.pipe(v.number(), v.finite(), v.minValue(0), v.maxValue(8.64e15));
const key = v.pipe(v.string(), v.maxLength(200));

/** A schema made from a check of another room. */
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

const identity = checked((value): Identity => {
  requireIdentity(value as Identity);
  const { timerClass, firmware, functions, memories, servos } = value as Identity;
  return { timerClass, firmware, functions, memories, servos };
});
/** The values that a timer can report. */
const held = checked((value) => requireProgram(value));
const typed = whole(-999_999, 999_999);
/** The values that can be typed. Those that no timer takes are kept until the pilot corrects them. */
const wanted: v.GenericSchema<unknown, TimerProgram> = v.pipe(
  v.object({
    identity,
    memory: v.nullable(whole(0, 254)),
    times: v.array(whole(-1e9, 1e9)),
    positions: v.array(v.array(typed)),
    idleThrottle: v.nullable(typed),
  }),
  v.check((program) => {
    try {
      requireShape(program);
      return program.memory === null || program.memory < program.identity.memories;
    } catch {
      return false;
    }
  }, 'the lists do not have the shape of the identity'),
);

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
/** The setting that a program belongs to. If it cannot be read, what was typed must not be lost. */
const of = v.optional(v.fallback(v.optional(v.object({ id: key, saved: held })), undefined));
const backupOf = v.optional(v.fallback(v.optional(key), undefined));
const steps = v.pipe(
  v.array(
    v.object({
      name: v.union([
        v.object({ code: v.picklist(STEP_CODES), params }),
        v.pipe(v.object({ code: v.picklist([...FORMER_STEPS.keys()]), params }), v.transform(presentStep)),
      ]),
      state: v.object({ working: wanted, texts, of, backupOf }),
    }),
  ),
  v.maxLength(MAX_STEPS),
);
function presentStep({ code, params }: { readonly code: string; readonly params: StepName['params'] }): StepName {
  return { code: FORMER_STEPS.get(code) as StepName['code'], params };
}

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
    /** Texts in fields that are not values yet, by field. */
    texts,
    of,
    backupOf,
    /** The steps to undo and redo; older drafts have none. If they cannot be read, the draft must not be lost. */
    history: v.optional(v.fallback(v.optional(history), undefined)),
    /** Milliseconds since 1970. */
    savedAt: date,
    /** When the baseline was read, in milliseconds since 1970; older drafts do not say. */
    readAt: v.optional(v.nullable(date)),
    /** When it was made, in milliseconds since 1970; only for a program that was read from no timer. */
    madeAt: v.exactOptional(date),
    /** Set for a program that was made here and closed: it comes to the screen only when the pilot opens it. */
    shelved: v.exactOptional(v.boolean()),
    /** Set for a memory that was opened without making it fly next. */
    apart: v.exactOptional(v.boolean()),
    /** Whether it comes from the simulated timer. */
    simulated: v.boolean(),
    /** The id of the model that it is for; absent when it is not known. */
    model: v.exactOptional(key),
  }),
  v.check(({ baseline, working }) => sameLayout(baseline.identity, working.identity), 'the two are not of one layout'),
);
export type Draft = v.InferOutput<typeof draftSchema>;

/**
 * A job that changes a timer, kept from before its first byte until somebody has seen its end. A write has the kind of
 * timer and the memory as key; a memory round trip the kind alone.
 */
export const unfinishedSchema = v.variant('kind', [
  v.pipe(
    v.object({
      kind: v.literal('write'),
      key,
      startedAt: date,
      /** What the timer held in the last reading before. */
      before: held,
      /** What it was to hold. */
      goal: held,
      /** When `before` was read, in milliseconds since 1970; older records do not say. */
      readAt: v.optional(v.nullable(date), null),
      /** When a fresh reading has explained what the timer holds. From then on only the offer to finish it is left. */
      seenAt: v.optional(v.nullable(date), null),
      /** Set for a position that was sent while the servos followed: no write that could be finished. */
      tried: v.exactOptional(v.literal(true)),
    }),
    v.check(({ before, goal }) => sameLayout(before.identity, goal.identity), 'the two are not of one layout'),
  ),
  v.object({
    kind: v.literal('memories'),
    key,
    startedAt: date,
    identity,
    /** The memory that was current and has to be restored, counted from 0; means nothing after `select`. */
    original: whole(0, 254),
    /** What it was; older records do not say. */
    job: v.exactOptional(v.picklist(['look', 'select', 'back-up', 'copy', 'restore'])),
    /** The memory that was looked at or selected, counted from 0. */
    memory: v.exactOptional(whole(0, 254)),
  }),
]);
export type Unfinished = v.InferOutput<typeof unfinishedSchema>;
export type UnfinishedWrite = Extract<Unfinished, { kind: 'write' }>;
export type UnfinishedRoundTrip = Extract<Unfinished, { kind: 'memories' }>;

/** What one memory of a timer held: before a write, or when the pilot asked for a backup. */
export const backupSchema = v.object({
  /** Its order is the order of time. */
  key,
  savedAt: date,
  reason: v.picklist(['write', 'memories']),
  program: held,
  simulated: v.boolean(),
  /** The id of the model that the timer belongs to; absent when that was not known. */
  model: v.exactOptional(key),
});
export type Backup = v.InferOutput<typeof backupSchema>;

/** Earlier versions did not check the order of a servo's ends: a model from a file may have them swapped. */
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

/** A model of the library, by its id. */
export const modelSchema = v.object({
  key,
  model: v.pipe(v.unknown(), v.transform(withEndsInOrder), checked(requireModel)),
  /** Milliseconds since 1970. */
  changedAt: date,
  /** What the memories of its timer held when they were last verified, one entry for each. */
  verified: v.pipe(
    v.array(
      v.object({ program: held, at: date, /** Of a simulated timer. */ simulated: v.exactOptional(v.boolean()) }),
    ),
    v.maxLength(255),
  ),
});
export type ModelRecord = v.InferOutput<typeof modelSchema>;

const versions = v.pipe(v.array(checked((value) => requireVersion(value))), v.maxLength(LIMITS.versions));
/** A setting of the library, by its id. */
export const settingSchema = v.object({
  key,
  setting: checked(requireSetting),
  changedAt: date,
  /**
   * What it held before, the latest first; older records have none. If they cannot be read, the setting must not be
   * lost.
   */
  versions: v.optional(v.fallback(v.optional(versions), undefined)),
});
export type SettingRecord = v.InferOutput<typeof settingSchema>;

/** A flight of the log, by its id. */
export const flightSchema = v.object({ key, flight: checked(requireFlight), changedAt: date });
export type FlightRecord = v.InferOutput<typeof flightSchema>;

/** Positions that were tried on the bench and neither kept nor put back, by kind of timer and memory. */
export const trialsSchema = v.pipe(
  v.unknown(),
  v.transform(withPresentNames),
  v.array(v.object({ key, before: held, touched: v.array(v.string()) })),
);

/** The open questions of docs/protocol.md that a pilot can settle with a timer. The usual answer stands first. */
export const ANSWERS = {
  /** Row 7: which byte of a time comes first. */
  order: ['low-first', 'high-first'],
  unit: ['hundredths', 'tenths'],
  /** From what the time of a function counts. */
  count: ['launch', 'previous'],
  /** Rows 4 and 14: the number of the first memory, where a timer says a number. */
  memories: ['from-0', 'from-1', 'unnumbered'],
  /** Row 9: what comes first in SETSERVO. */
  layout: ['function-first', 'servo-first'],
  /** Row 15: whether a position is kept also where the servos do not stand. */
  stores: ['anywhere', 'there'],
  /** Whether SETSERVO alone moves a servo; `there`: only where the servos stand. */
  moves: ['always', 'never', 'there'],
  /** Row 1: requests with four zeros. */
  zeros: ['answered', 'unanswered'],
  /** Row 3: the letter of the reply to UNLOCK. */
  unlock: ['6E', '6A'],
} as const;

/** What was settled with a timer of a kind: nothing else is kept of it. */
export const settledSchema = v.pipe(
  v.array(
    v.strictObject({
      key,
      answers: v.strictObject({
        order: v.exactOptional(v.picklist(ANSWERS.order)),
        unit: v.exactOptional(v.picklist(ANSWERS.unit)),
        count: v.exactOptional(v.picklist(ANSWERS.count)),
        memories: v.exactOptional(v.picklist(ANSWERS.memories)),
        layout: v.exactOptional(v.picklist(ANSWERS.layout)),
        stores: v.exactOptional(v.picklist(ANSWERS.stores)),
        moves: v.exactOptional(v.picklist(ANSWERS.moves)),
        zeros: v.exactOptional(v.picklist(ANSWERS.zeros)),
        unlock: v.exactOptional(v.picklist(ANSWERS.unlock)),
        /** How long an answer usually takes, from the request on, in whole milliseconds. */
        delay: v.exactOptional(whole(0, 60_000)),
        /** The reserved time of a B or an E, low byte first. Only noted: nobody knows what it is for. */
        reserved: v.exactOptional(whole(0, 0xffff)),
      }),
    }),
  ),
  v.maxLength(100),
);
export type Answers = v.InferOutput<typeof settledSchema>[number]['answers'];

/** What is remembered of a port. Two adapters of one kind share it, because nothing tells them apart. */
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
  /** The rate at which a timer last answered; null for none. */
  foundRate: v.nullable(whole(1, 100_000_000)),
  /** What was assumed about the timers on this port, by kind of timer: a first guess for the next one. */
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
 * Stored data that cannot be read, unchanged: it may matter to somebody, and a later version may be able to read it.
 */
export const asideSchema = v.object({
  key: v.pipe(v.string(), v.maxLength(1000)),
  /** The shelf on which it was. */
  shelf: v.pipe(v.string(), v.maxLength(100)),
  /** When it was set aside, in milliseconds since 1970. */
  at: date,
  stored: v.unknown(),
});
export type AsideRecord = v.InferOutput<typeof asideSchema>;

/** Each shelf of the storage with what stands on it. `strict`: what is saved is on the disk, see `changeShelves`. */
export const RECORDS = {
  drafts: { schema: draftSchema, durability: 'relaxed' },
  unfinished: { schema: unfinishedSchema, durability: 'strict' },
  backups: { schema: backupSchema, durability: 'strict' },
  ports: { schema: portSchema, durability: 'relaxed' },
  /** Records of the other shelves that cannot be read. */
  aside: { schema: asideSchema, durability: 'relaxed' },
  models: { schema: modelSchema, durability: 'strict' },
  settings: { schema: settingSchema, durability: 'strict' },
  flights: { schema: flightSchema, durability: 'strict' },
} as const;
