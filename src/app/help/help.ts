import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { Session } from '../session/session.js';
import { Checklist } from './checklist.js';
import { FirstSteps } from './first-steps.js';

/** What help there is, in the order in which it stands there; the first is shown where none is named. */
export const HELP_PAGES = ['checklist', 'trouble', 'words', 'energy', 'steps'] as const;
export type HelpPage = (typeof HELP_PAGES)[number];

/** The page that an address names. */
export function helpPageAt(path: string): HelpPage {
  return HELP_PAGES.find((page) => page === path) ?? HELP_PAGES[0];
}

/** What the help remembers while the pilot is elsewhere. */
export class Help {
  readonly steps = new FirstSteps();
  readonly checklist: Checklist;
  readonly #explaining = signal(false, { name: 'explaining' });
  /** Whether it is told what the columns and rows of the program are. */
  readonly explaining: ReadonlySignal<boolean> = this.#explaining;

  constructor({ editor, connection, link }: Session) {
    this.checklist = new Checklist(computed(() => editor.identity.value?.timerClass ?? null));
    effect(() => {
      // Whoever has reached a timer needs to be told no more of how that is done.
      if (connection.value && !link.simulated.value) this.steps.end();
    });
  }

  explain(open: boolean): void {
    this.#explaining.value = open;
  }

  /** Always the same function: a table that is given it is not drawn anew. */
  readonly explainNow = (): void => this.explain(true);
}
