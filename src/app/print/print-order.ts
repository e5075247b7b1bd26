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

/** A view from which something is printed. */
export type PrintHome = 'program' | 'memories' | 'library';

/** Which settings to print. The other views need to know nothing else about printing. */
export class PrintOrder {
  // Only this model writes them.
  /** The keys of the settings in their order, {@link ON_SCREEN} among them. */
  readonly keys = signal<readonly string[]>([ON_SCREEN]);
  /** The view to which the print leads back. What is added to the print, or removed, does not change it. */
  readonly home = signal<PrintHome>('program');

  /** Prints only these settings; without any, the program on the screen. */
  choose(keys: readonly string[] = [ON_SCREEN]): void {
    this.keys.value = [...new Set(keys)];
    this.home.value = homeOf(keys[0]);
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

/** The view in which the first of what is printed is at home. */
function homeOf(key: string = ON_SCREEN): PrintHome {
  return isOfLibrary(key) ? 'library' : key === ON_SCREEN ? 'program' : 'memories';
}
