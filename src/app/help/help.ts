import { computed } from '@preact/signals';
import type { Session } from '../work/session.js';
import { Checklist } from './checklist.js';

/** The pages of the help, in their order. The first is shown when an address names none. */
export const HELP_PAGES = ['checklist', 'trouble', 'words', 'steps'] as const;
export type HelpPage = (typeof HELP_PAGES)[number];

/** The page that an address names. */
export function helpPageAt(path: string): HelpPage {
  return HELP_PAGES.find((page) => page === path) ?? HELP_PAGES[0];
}

/** What the help remembers while the pilot is elsewhere. */
export class Help {
  readonly checklist: Checklist;

  constructor({ editor }: Pick<Session, 'editor'>) {
    this.checklist = new Checklist(computed(() => editor.identity.value?.timerClass ?? null));
  }
}
