/** Before the other sentences are there. */
export const first = {
  failed: 'The page could not be loaded whole. Is there a network?',
  again: 'Load it again',
};
