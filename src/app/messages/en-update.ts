/** A new version of the page. */
export const update = {
  /** @param version null where it does not say. */
  ready: (version: string | null) =>
    version === null ? 'A new version is ready.' : `A new version is ready: ${version}.`,
  /** It was taken, and cannot begin yet. */
  waits: (version: string | null) =>
    version === null ? 'The new version waits.' : `The new version ${version} waits.`,
  take: 'Use it now',
  later: {
    port: 'It starts when you disconnect.',
    edits: 'It starts when what you typed is kept or written.',
    open: 'It starts when you close what is open.',
  },
  news: 'What is new',
  version: (version: string) => `Version ${version}`,
  close: 'Close',
};

/** Which version of the page this is. */
export const aboutPage = {
  title: 'This page',
  version: (version: string) => `Sidus Timer ${version}.`,
  offline: 'All of it is on this device: it works without a network.',
  notOffline: 'It is not kept on this device yet: open it once with a network.',
  take: (version: string | null) =>
    version === null ? 'Use the new version now' : `Use the new version ${version} now`,
  licences: 'Licences',
  madeWith: 'This page, and the work of others that it contains. Each opens with its licence in full.',
  package: (name: string, version: string, licence: string) => `${name} ${version}, ${licence}`,
};
