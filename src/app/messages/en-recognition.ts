import { apart } from './apart.js';

/** The model in the strip. */
export const recognition = {
  /** In the strip, in place of a model's name. */
  which: 'Which model?',
  /** A button that shows the name of the model. */
  change: (model: string) => `Model ${apart(model)}: say which model it is`,
};

/** A memory with the pilot's name for it: M2 “fly-off”. */
export const memoryNames = {
  named: (memory: string, name: string) => `${memory} “${apart(name)}”`,
};
