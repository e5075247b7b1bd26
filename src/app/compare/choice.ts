import { batch, signal } from '@preact/signals';

/** The address of the comparison, after `#library/`. */
export const COMPARE = 'compare';
/** The key of the program on the screen. */
export const SCREEN = 'screen';
/** @param memory counted from 0. */
export const memoryKey = (memory: number): string => `timer/${memory}`;
export const settingKey = (id: string): string => `setting/${id}`;
/** The key of an earlier version of a setting. */
export const versionKey = (id: string, until: number): string => `version/${id}/${until}`;
export const backupKey = (key: string): string => `backup/${key}`;

/** Which two programs are compared. Outlasts the page of the comparison. */
export class ComparedPair {
  // Only this model writes them.
  readonly first = signal<string | null>(null, { name: 'firstSide' });
  readonly second = signal<string | null>(null, { name: 'secondSide' });

  /** Chooses by keys; null leaves the choice to the page. */
  show(first: string | null, second: string | null): void {
    batch(() => {
      this.first.value = first;
      this.second.value = second;
    });
  }
}
