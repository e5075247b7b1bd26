import { signal } from '@preact/signals';
import type { LineEntry } from '../../client/index.js';

/** More than a pilot scrolls through, and little enough to keep for a whole day. */
const KEPT = 500;

/** What was last on the line, newest last. */
export class LineLog {
  readonly entries = signal<readonly LineEntry[]>([], { name: 'line' });

  readonly add = (entry: LineEntry): void => {
    this.entries.value = [...this.entries.value.slice(1 - KEPT), entry];
  };

  clear(): void {
    this.entries.value = [];
  }
}
