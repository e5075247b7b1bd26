import { computed, type ReadonlySignal } from '@preact/signals';
import type { TimerConnection } from '../../serial/index.js';
import type { Editor } from '../editing/editor.js';
import type { Knowledge } from './knowledge.js';

/**
 * How certain it is that the timer still holds what was read of the memory on the screen.
 * Times are milliseconds since 1970.
 */
export type Standing =
  /** It was read on this connection, and nothing was sent since. */
  | { readonly sure: 'now'; readonly at: number; readonly verified: boolean }
  /** It was read earlier: the timer may hold something else by now. `at` is null when the time was not kept. */
  | { readonly sure: 'once'; readonly at: number | null }
  /** A write into it was interrupted. */
  | { readonly sure: 'not'; readonly at: number | null };

/** What marks, figures and lines may say about the program on the screen: see {@link Standing}. */
export function standingOf(
  editor: Editor,
  knowledge: Knowledge,
  connection: ReadonlySignal<TimerConnection | null>,
): ReadonlySignal<Standing> {
  const memory = computed(() => editor.working.value?.memory ?? null);
  return computed(() => {
    const known = knowledge.of(memory.value);
    if (known.state === 'uncertain') return { sure: 'not', at: known.readAt };
    if (known.state === 'unread') return { sure: 'once', at: null };
    const { at, verified } = known;
    return connection.value && editor.fresh.value ? { sure: 'now', at, verified } : { sure: 'once', at };
  });
}
