import type { TimerProgram } from '../../program/index.js';
import { type Known, lastRead } from '../session/known.js';
import type { Session } from '../session/session.js';
import { memoryKey } from './print-order.js';

/** A memory of the timer that was read. */
export interface ReadMemory {
  readonly key: string;
  readonly memory: number;
  readonly known: Known;
  /** What it held at its last complete reading. */
  readonly program: TimerProgram;
}

/** All memories of the timer that were read. */
export function readMemories({ editor, knowledge }: Session): readonly ReadMemory[] {
  const count = editor.baseline.value?.identity.memories ?? 0;
  return Array.from({ length: count }, (_, memory) => memory).flatMap((memory) => {
    const known = knowledge.of(memory);
    const program = lastRead(known);
    return program ? [{ key: memoryKey(memory), memory, known, program }] : [];
  });
}
