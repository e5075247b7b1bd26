/** For the time before the other sentences are loaded. */
export const first = {
  failed: 'The page is not complete. Is there a network?',
  again: 'Load it again',
};
