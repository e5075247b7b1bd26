/** A new version of the page. */
export const update = {
  /** @param version null when the new version does not say. */
  ready: (version: string | null) =>
    version === null ? 'A new version is ready.' : `A new version is ready: ${version}.`,
  /** The pilot has accepted it, but it cannot start yet. */
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
};

/** The version of this page. */
export const aboutPage = {
  title: 'This page',
  version: (version: string) => `Sidus Timer ${version}.`,
  offline: 'The whole page is on this device: it works without a network.',
  notOffline: 'The page is not kept on this device yet: open it once with a network.',
  take: (version: string | null) =>
    version === null ? 'Use the new version now' : `Use the new version ${version} now`,
  licences: 'Licences',
  madeWith: 'This page, and the work of others that it contains. Open one to read its whole licence.',
  package: (name: string, version: string, licence: string) => `${name} ${version}, ${licence}`,
};
