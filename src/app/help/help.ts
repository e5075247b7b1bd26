/** The pages of the help, in their order. The first is shown when an address names none. */
export const HELP_PAGES = ['checklist', 'trouble', 'words', 'steps'] as const;
export type HelpPage = (typeof HELP_PAGES)[number];

/** The page that an address names. */
export function helpPageAt(path: string): HelpPage {
  return HELP_PAGES.find((page) => page === path) ?? HELP_PAGES[0];
}
