/** A new version of the page. */
export const update = {
  ready: 'A new version is ready.',
  waits: 'It starts when you disconnect and nothing is open or unsaved.',
  take: 'Use it now',
  news: 'What is new',
};

/** The version of this page. */
export const aboutPage = {
  title: 'This page',
  version: (version: string) => `Sidus Timer ${version}.`,
  offline: 'The whole page is on this device: it works without a network.',
  notOffline: 'The page is not kept on this device yet: open it once with a network.',
  licences: 'Licences',
};
