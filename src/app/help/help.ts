import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { Session } from '../session/session.js';
import { Checklist } from './checklist.js';
import { FirstSteps } from './first-steps.js';

/** The pages of the help, in their order. The first is shown when an address names none. */
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
  /** Whether the explanation of the program's columns and rows is open. */
  readonly explaining: ReadonlySignal<boolean> = this.#explaining;

  constructor({ editor, connection, link }: Session) {
    this.checklist = new Checklist(computed(() => editor.identity.value?.timerClass ?? null));
    effect(() => {
      // A pilot who has reached a timer no longer needs to be told how.
      if (connection.value && !link.simulated.value) this.steps.end();
    });
  }

  explain(open: boolean): void {
    this.#explaining.value = open;
  }

  /** Always the same function, so that a table with it is not drawn again. */
  readonly explainNow = (): void => this.explain(true);
}
