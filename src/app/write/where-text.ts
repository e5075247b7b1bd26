import type { Model } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';

/** “M1 “calm” of Lancer 07”, as far as it is known. */
export function whereText(session: Session, memory: number | null, model: Model | null): string {
  const name = memory === null ? messages.value.knowledge.thisMemory : memoryText(session, memory);
  return model ? moreMessages.value.whichModel.crossing.memoryOf({ memory: name, model: model.name }) : name;
}
