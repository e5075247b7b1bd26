/**
 * The other end of the wire: a virtual timer with quirks, and a timer that replays a recording.
 * @module simulator
 */

export { exampleMemories } from './example-memories.js';
export type { MemoryContent } from './memory.js';
export type { TimerQuirks } from './quirks.js';
export { ReplayTimer, type ReplayTimerOptions } from './replay.js';
export type { TimerCore, TimerCoreOptions } from './timer-core.js';
export { type LineFaults, VirtualTimer, type VirtualTimerOptions } from './virtual-timer.js';
