/** For the time before the other sentences are loaded. */
export const first = {
  failed: 'A part of the page could not be loaded. Is there a network?',
  slow: 'The page is still loading. The network may be slow. If nothing comes, load it again.',
  again: 'Load it again',
};
