import { signal } from '@preact/signals';

/** How the language of the page writes numbers, and what it calls the rows and columns of the table. */
export interface Locale {
  readonly decimal: '.' | ',';
  /** Its words in small letters, each with one that `paste-names.ts` knows. */
  readonly words: readonly (readonly [own: string, known: string])[];
}

/** Of the language that the page speaks. `messages/language.ts` sets it. */
export const locale = signal<Locale>({ decimal: '.', words: [] });
