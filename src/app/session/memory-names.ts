import { LIMITS, type Model } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { beginningOf } from './plain-names.js';
import type { Session } from './session.js';

/** What the pilot calls a memory of a model; empty where he calls it nothing. */
export function givenName(model: Model | null, memory: number): string {
  return model?.memoryNames[memory] ?? '';
}

/** A memory of the timer at hand, as it is called in a sentence: M2, or M2 “fly-off”. */
export function memoryText({ modelAtHand }: Pick<Session, 'modelAtHand'>, memory: number): string {
  return memoryOf(modelAtHand.value, memory);
}

/**
 * A memory of a model, as it is called in a sentence.
 * @param memory counted from 0; null for a timer that does not say which is current.
 */
export function memoryOf(model: Model | null, memory: number | null): string {
  const { memoryName, memoryNames, recovery } = messages.value;
  if (memory === null) return recovery.unknownMemory;
  const given = givenName(model, memory);
  return given === '' ? memoryName(memory) : memoryNames.named(memoryName(memory), given);
}

/** Calls a memory of the model at hand something else; an empty name takes its name away. */
export async function nameMemory(session: Session, memory: number, name: string): Promise<void> {
  const model = session.modelAtHand.peek();
  const given = beginningOf(name.trim(), LIMITS.name);
  if (!model || givenName(model, memory) === given) return;
  const memoryNames = [...model.memoryNames];
  while (memoryNames.length <= memory) memoryNames.push('');
  memoryNames[memory] = given;
  await session.library.keepModel({ ...model, memoryNames });
}
