import { useSignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useRef } from 'preact/hooks';
import { libraryMessages } from '../messages/en-library.js';
import type { Browse } from './browse.js';
import './arrange.css';

export function ArrangeButton({ browse }: { readonly browse: Browse }) {
  const { arrange: words } = libraryMessages;
  const isOn = browse.arranging.value;
  return (
    <button type="button" class="quiet" aria-pressed={isOn} onClick={() => browse.arrange(!isOn)}>
      {isOn ? words.done : words.start}
    </button>
  );
}

interface ArrangeProps<T extends { readonly key: string }> {
  /** Whether rows can be moved now. */
  readonly on: boolean;
  readonly class: string;
  readonly items: readonly T[];
  readonly nameOf: (item: T) => string;
  /** The keys of all items in their new order. */
  readonly onMove: (keys: readonly string[]) => void;
  /** Rows that stay at the end. */
  readonly after?: ComponentChildren;
  readonly children: (item: T) => ComponentChildren;
}

/**
 * A list whose rows can be put into another order: by their handles, with mouse or finger, and by their arrow buttons.
 */
export function Arrange<T extends { readonly key: string }>(props: ArrangeProps<T>) {
  const { on, items, nameOf, onMove, after, children, class: name } = props;
  const { arrange: words } = libraryMessages;
  const list = useRef<HTMLUListElement>(null);
  const held = useSignal<string | null>(null);
  const said = useSignal('');
  const move = (key: string, to: number): void => {
    const keys = items.map((item) => item.key);
    const from = keys.indexOf(key);
    const at = Math.max(0, Math.min(keys.length - 1, to));
    if (from < 0 || at === from) return;
    keys.splice(from, 1);
    keys.splice(at, 0, key);
    onMove(keys);
    const item = items[from];
    if (item) said.value = words.moved(nameOf(item), at + 1, keys.length);
  };
  /** The row under a finger. */
  const rowAt = (y: number): number => {
    const rows = [...(list.current?.querySelectorAll('li[data-key]') ?? [])];
    return rows.findIndex((row) => y < row.getBoundingClientRect().bottom);
  };
  const drag = (key: string, event: PointerEvent): void => {
    if (held.peek() !== key) return;
    event.preventDefault();
    const to = rowAt(event.clientY);
    move(key, to < 0 ? items.length - 1 : to);
  };
  return (
    <>
      {on && <p class="hint">{words.hint}</p>}
      <ul class={`${name} ${on ? 'arranging' : ''}`} ref={list}>
        {items.map((item, at) => (
          <li key={item.key} data-key={item.key} class={held.value === item.key ? 'held' : undefined}>
            {on && (
              <span
                class="grip"
                aria-hidden="true"
                title={words.drag(nameOf(item))}
                onPointerDown={(event) => {
                  event.currentTarget.setPointerCapture(event.pointerId);
                  held.value = item.key;
                }}
                onPointerMove={(event) => drag(item.key, event)}
                onPointerUp={() => (held.value = null)}
                onPointerCancel={() => (held.value = null)}
              >
                {words.signs.drag}
              </span>
            )}
            {children(item)}
            {on && (
              <span class="arrows">
                <button
                  type="button"
                  class="quiet"
                  aria-label={words.up(nameOf(item))}
                  aria-disabled={at === 0}
                  onClick={() => move(item.key, at - 1)}
                >
                  {words.signs.up}
                </button>
                <button
                  type="button"
                  class="quiet"
                  aria-label={words.down(nameOf(item))}
                  aria-disabled={at === items.length - 1}
                  onClick={() => move(item.key, at + 1)}
                >
                  {words.signs.down}
                </button>
              </span>
            )}
          </li>
        ))}
        {after}
      </ul>
      {on && (
        <p class="visually-hidden" role="status">
          {said.value}
        </p>
      )}
    </>
  );
}
