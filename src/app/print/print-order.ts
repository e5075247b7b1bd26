import { signal } from '@preact/signals';

/** Stands for the program on the screen among the keys of settings. */
export const ON_SCREEN = 'on screen';

/** Stands for the last reading of a memory of the timer, counted from 0. */
export const memoryKey = (memory: number): string => `memory ${memory}`;

/** Whether it is the key of a setting in the library: none of those has a space. */
export const isOfLibrary = (key: string): boolean => !key.includes(' ');

/** The papers in the printer, by the names that they have in every language. */
export const PAPERS = { a5: 'A5', a4: 'A4', letter: 'Letter' } as const;
export type Paper = keyof typeof PAPERS;
export const PAPER_KEYS = Object.keys(PAPERS) as readonly Paper[];

/** Which settings to print. The other views need to know nothing else about printing. */
export class PrintOrder {
  // Only this model writes them.
  /** The keys of the settings in their order, {@link ON_SCREEN} among them. */
  readonly keys = signal<readonly string[]>([ON_SCREEN]);
  /** Where the first of what is printed is at home. What is added to the print, or removed, does not change it. */
  readonly home = signal<'program' | 'memories' | 'library'>('program');

  /** Prints only these settings; without any, the program on the screen. */
  choose(keys: readonly string[] = [ON_SCREEN]): void {
    this.keys.value = [...new Set(keys)];
    const [first = ON_SCREEN] = keys;
    this.home.value = isOfLibrary(first) ? 'library' : first === ON_SCREEN ? 'program' : 'memories';
  }

  /** Removes all settings from the print. */
  clear(): void {
    this.keys.value = [];
  }

  /** Adds a setting to the print, or removes it. */
  toggle(key: string): void {
    const keys = this.keys.peek();
    this.keys.value = keys.includes(key) ? keys.filter((each) => each !== key) : [...keys, key];
  }
}
