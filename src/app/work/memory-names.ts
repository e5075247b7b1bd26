import { LIMITS, type Model } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { memoryName } from '../messages/names.js';
import { beginningOf } from '../records/plain-names.js';
import type { Session } from './session.js';

/** The pilot's name for a memory of a model; empty without one. */
export function givenName(model: Pick<Model, 'memoryNames'> | null, memory: number): string {
  return model?.memoryNames[memory] ?? '';
}

/** The name of a memory of the connected timer in a sentence: M2, or M2 “fly-off”. */
export function memoryText({ origin }: Pick<Session, 'origin'>, memory: number): string {
  return memoryOf(origin.named.value, memory);
}

/**
 * The name of a memory of a model in a sentence.
 * @param memory counted from 0; null for a timer that does not say which is current.
 */
export function memoryOf(model: Pick<Model, 'memoryNames'> | null, memory: number | null): string {
  const { memoryNames, recovery } = messages.value;
  if (memory === null) return recovery.unknownMemory;
  const given = givenName(model, memory);
  return given === '' ? memoryName(memory) : memoryNames.named({ memory: memoryName(memory), name: given });
}

/** Names a memory of the present model. An empty name removes the name. */
export function nameMemory(session: Pick<Session, 'origin' | 'library'>, memory: number, name: string): void {
  const model = session.origin.named.peek();
  const given = beginningOf(name.trim(), LIMITS.name);
  if (!model || givenName(model, memory) === given) return;
  const memoryNames = [...model.memoryNames];
  while (memoryNames.length <= memory) memoryNames.push('');
  memoryNames[memory] = given;
  void session.library.changeModel(model.id, { memoryNames });
}
