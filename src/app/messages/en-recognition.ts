/** The model in the strip. */
export const recognition = {
  /** In the strip, in the place of a model's name. */
  which: 'Which model?',
  /** A button that shows the name of the model. */
  change: (model: string) => `Model ${model}: say which model it is`,
};

/** A memory and what the pilot calls it: M2 “fly-off”. */
export const memoryNames = {
  named: (memory: string, name: string) => `${memory} “${name}”`,
};
