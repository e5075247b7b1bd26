import { computed, type ReadonlySignal } from '@preact/signals';
import type { TimerConnection } from '../../serial/index.js';
import type { Editor } from '../editing/editor.js';
import type { Knowledge } from './knowledge.js';

/**
 * How far what was read of the memory on the screen can be called what the timer holds. Times are milliseconds since
 * 1970.
 */
export type Standing =
  /** It was read on this connection, and nothing was sent since. */
  | { readonly sure: 'now'; readonly at: number; readonly verified: boolean }
  /** It was read once: the timer may hold something else by now. When is null where that was not kept. */
  | { readonly sure: 'once'; readonly at: number | null }
  /** A write into it was cut off. */
  | { readonly sure: 'not'; readonly at: number | null };

/** What marks, figures and lines may say of the program on the screen: see {@link Standing}. */
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
