import * as v from 'valibot';
import type { TimerProgram } from '../../program/index.js';
import type { Content } from '../edit/content.js';
import { type History, MAX_STEPS, STEP_CODES } from '../edit/history.js';

const finite = v.pipe(v.number(), v.finite());
const index = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(255));
const identity = v.object({
  timerClass: v.pipe(v.string(), v.regex(/^[!-~]$/)),
  firmware: v.string(),
  functions: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(125)),
  memories: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(255)),
  servos: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(126)),
});
const program: v.GenericSchema<unknown, TimerProgram> = v.pipe(
  v.object({
    identity,
    memory: v.nullable(finite),
    timers: v.array(finite),
    positions: v.array(v.array(finite)),
    idleThrottle: v.nullable(finite),
  }),
  v.check(({ identity: { functions, servos }, timers, positions }) => {
    const columns = functions + 1;
    return timers.length === columns && positions.length === servos && positions.every((row) => row.length === columns);
  }, 'the lists do not have the shape of the identity'),
);

const texts = v.record(v.string(), v.string());
const steps = v.pipe(
  v.array(
    v.object({
      name: v.object({
        code: v.picklist(STEP_CODES),
        params: v.record(v.string(), v.union([v.string(), finite])),
      }),
      state: v.object({ working: program, texts }),
    }),
  ),
  v.maxLength(MAX_STEPS),
);
const history: v.GenericSchema<unknown, History<Content>> = v.object({
  past: steps,
  future: steps,
  open: v.nullable(v.string()),
});

/** What a pilot was working on, under the kind of timer and the memory that it is for. */
export const draftSchema = v.object({
  key: v.string(),
  /** What the timer held when the work began. */
  baseline: program,
  working: program,
  /** Texts in fields that are no values yet, by field. */
  texts,
  /** What can be undone and redone; older drafts have none. One that cannot be read is no reason to lose the draft. */
  history: v.optional(v.fallback(v.optional(history), undefined)),
  /** Milliseconds since 1970. */
  savedAt: v.number(),
  /** Whether it came from the simulated timer. */
  simulated: v.boolean(),
  /** The number of the tab that it was worked on in, see `TabNumber`. */
  tab: v.optional(v.number(), 1),
});
export type Draft = v.InferOutput<typeof draftSchema>;

/**
 * A job that has begun to change a timer, kept from before its first byte until its end was seen. A write, under the kind of timer and
 * the memory that it is for; or a walk through the memories, under the kind alone.
 */
export const unfinishedSchema = v.variant('kind', [
  v.object({
    kind: v.literal('write'),
    key: v.string(),
    startedAt: v.number(),
    /** What the timer held by the last reading before. */
    before: program,
    /** What it was to hold. */
    goal: program,
    /** When `before` was read, in milliseconds since 1970; older records do not say. */
    readAt: v.optional(v.nullable(v.number()), null),
    /** When a fresh reading explained what the timer holds: from then on only the offer to finish it is left. */
    seenAt: v.optional(v.nullable(v.number()), null),
    /** The number of the tab in which it is under way, see `TabNumber`; null when that has seen its end. */
    tab: v.optional(v.nullable(v.number()), null),
  }),
  v.object({
    kind: v.literal('memories'),
    key: v.string(),
    startedAt: v.number(),
    identity,
    /** The memory that was current, and is to be current again; counted from 0. */
    home: index,
  }),
]);
export type Unfinished = v.InferOutput<typeof unfinishedSchema>;
export type UnfinishedWrite = Extract<Unfinished, { kind: 'write' }>;
export type UnfinishedWalk = Extract<Unfinished, { kind: 'memories' }>;

/** What one memory of a timer held at a time: before a write, or when the pilot asked for it. */
export const backupSchema = v.object({
  /** Sorts by time. */
  key: v.string(),
  savedAt: v.number(),
  reason: v.picklist(['write', 'memories']),
  program,
  simulated: v.boolean(),
});
export type Backup = v.InferOutput<typeof backupSchema>;

/** What was tried on the bench and is neither kept nor put back yet, under the kind of timer and the memory. */
export const trialsSchema = v.array(v.object({ key: v.string(), before: program, touched: v.array(v.string()) }));

/** What is remembered of a port. Two adapters of one make share it: nothing tells them apart. */
export const portSchema = v.object({
  key: v.string(),
  usedAt: v.number(),
  settings: v.object({
    baudRate: v.union([v.literal('find'), v.pipe(v.number(), v.integer(), v.minValue(1))]),
    dataBits: v.picklist([7, 8]),
    parity: v.picklist(['none', 'even', 'odd']),
    stopBits: v.picklist([1, 2]),
    dtr: v.nullable(v.boolean()),
    rts: v.nullable(v.boolean()),
  }),
  /** The rate at which a timer answered last; null when none has. */
  foundRate: v.nullable(v.pipe(v.number(), v.integer(), v.minValue(1))),
  /** What was taken for true of the timers at this port, by kind of timer: a first guess for the next one. */
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
