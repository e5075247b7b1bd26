/** For the time before the other sentences are loaded. */
export const first = {
  failed: 'A part of the page could not be loaded. Is there a network?',
  again: 'Load it again',
};
