import { shortcutLetter } from './shortcut-letter.js';

/** What a key does in every view: `?` opens the help, Ctrl+K or Cmd+K the list of commands, Ctrl+P or Cmd+P prints. */
export type PageKey = 'help' | 'commands' | 'print';

/** An older key is not carried out late: the pilot no longer waits for it. Milliseconds. */
const FRESH = 10_000;
/** They come down before another key and say nothing of their own. */
const MODIFIERS = ['Shift', 'Control', 'Meta', 'Alt', 'AltGraph', 'CapsLock'];

/** With Ctrl or Cmd. */
const COMMANDS: Readonly<Record<string, PageKey>> = { k: 'commands', p: 'print' };

/** Carries the key out. @returns whether it did. */
type Act = () => boolean;

const acts = new Map<PageKey, Act>();
/** The last key that was pressed while nobody could carry it out. */
let waiting: { readonly key: PageKey; readonly at: number } | null = null;

/**
 * From now on a key that is pressed before the page can carry it out waits for it, until the pilot does anything else.
 */
export function holdPageKeys(): void {
  // A listener that is added twice still counts once.
  addEventListener('keydown', onKey);
  addEventListener('pointerdown', forget, true);
}

/** @returns a function that ends this: from then on the key waits for the next one. */
export function takePageKey(key: PageKey, act: Act): () => void {
  holdPageKeys();
  acts.set(key, act);
  if (waiting?.key === key) {
    const { at } = waiting;
    forget();
    if (performance.now() - at < FRESH) act();
  }
  return () => {
    if (acts.get(key) === act) acts.delete(key);
  };
}

function forget(): void {
  waiting = null;
}

function onKey(event: KeyboardEvent): void {
  if (MODIFIERS.includes(event.key)) return;
  forget();
  const key = keyOf(event);
  if (key === null || event.defaultPrevented) return;
  const act = acts.get(key);
  if (!act) waiting = { key, at: event.timeStamp };
  if (!act || act()) event.preventDefault();
}

function keyOf(event: KeyboardEvent): PageKey | null {
  const { target, key, ctrlKey, metaKey, altKey, shiftKey } = event;
  const isCommand = ctrlKey || metaKey;
  if (isCommand && !shiftKey) return COMMANDS[shortcutLetter(event) ?? ''] ?? null;
  const isTyped = target instanceof Element && target.closest('input, textarea, select, [contenteditable]') !== null;
  return key === '?' && !isCommand && !altKey && !isTyped ? 'help' : null;
}
