import { shortcutLetter } from './shortcut-letter.js';

/** What a key does in every view: `?` opens the help, Ctrl+K or Cmd+K the list of commands, Ctrl+P or Cmd+P prints. */
export type PageKey = 'help' | 'commands' | 'print';

/** With Ctrl or Cmd. */
const COMMANDS: Readonly<Record<string, PageKey>> = { k: 'commands', p: 'print' };

/**
 * @param act carries the key out, and returns whether it did. Else it is left to the browser.
 * @returns a function that ends this.
 */
export function onPageKey(key: PageKey, act: () => boolean): () => void {
  const onKey = (event: KeyboardEvent): void => {
    if (keyOf(event) === key && !event.defaultPrevented && act()) event.preventDefault();
  };
  addEventListener('keydown', onKey);
  return () => removeEventListener('keydown', onKey);
}

function keyOf(event: KeyboardEvent): PageKey | null {
  const { target, key, ctrlKey, metaKey, altKey, shiftKey } = event;
  const isCommand = ctrlKey || metaKey;
  if (isCommand && !shiftKey) return COMMANDS[shortcutLetter(event) ?? ''] ?? null;
  const isTyped = target instanceof Element && target.closest('input, textarea, select, [contenteditable]') !== null;
  return key === '?' && !isCommand && !altKey && !isTyped ? 'help' : null;
}
