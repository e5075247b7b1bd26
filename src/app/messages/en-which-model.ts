import { apart } from './apart.js';
import { plural } from './plural.js';

/** How many models one sentence names. The list of models has all of them. */
const NAMED = 6;

/** A choice in one phrase: “Lancer, Vega or 3 more”. */
const either = (names: readonly string[]): string => {
  const own = names.map(apart);
  const all = names.length <= NAMED ? own : [...own.slice(0, NAMED - 1), `${names.length - NAMED + 1} more`];
  return all.length < 2 ? (all[0] ?? '') : `${all.slice(0, -1).join(', ')} or ${all.at(-1)}`;
};

/** Which model the connected timer belongs to: as its content shows, or as the pilot says. */
const recognition = {
  /** @param when a day, or a time of today. */
  same: (model: string, when: string) => `This is ${apart(model)}, as seen ${when}.`,
  like: (model: string, count: number) =>
    `This is like ${apart(model)}, ${plural(count, 'value differs', 'values differ')}. Is it ${apart(model)}?`,
  several: (models: readonly string[]) => `This may be ${either(models)}. Which model is it?`,
  unknown: 'This timer is not known here. Which model is it?',
  yes: (model: string) => `Yes, ${model}`,
  choose: 'Choose…',
  ok: 'OK',
  dialog: {
    title: 'Which model is it?',
    lead: 'A timer does not know its model. The page compares what it holds with what it last saw in each model.',
    said: (model: string) => `You have said that it is ${model}.`,
    moreMemories: 'Read the other memories, too: they may tell the models apart.',
    none: 'No such model of this class.',
    newModel: 'A new model',
    keep: 'Keep as a new model',
    taken: 'A model of this name is in the list already.',
  },
};

/** The names of the memories, in the place where they are typed. */
const memoryNames = {
  label: (memory: string) => `Name of ${memory}`,
  give: 'Name',
};

/** Values of one model that are about to be written into the timer of another. */
const crossing = {
  /** @param to the models to which the timer may belong. */
  title: (from: string, to: readonly string[]) =>
    `These are values of ${from}, but this timer looks like that of ${either(to)}.`,
  advice: 'With the values of another model you can lose this one. Look at the model in front of you.',
  confirm: (from: string, to: readonly string[]) => `Write values of ${from} into the timer of ${either(to)}.`,
  /** @param memory with its name. */
  memoryOf: (memory: string, model: string) => `${memory} of ${apart(model)}`,
};

/** Which model it is. The parts of the page that ask load these sentences. */
export const modelMessages = { recognition, memoryNames, crossing };
