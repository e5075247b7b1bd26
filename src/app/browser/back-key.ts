import { service, tried } from './services.js';

/** The part of it that the page uses. TypeScript does not know it yet. */
interface CloseWatcherLike {
  addEventListener(type: 'close', listener: () => void): void;
  destroy(): void;
}

declare global {
  var CloseWatcher: { readonly prototype: CloseWatcherLike; new (): CloseWatcherLike };
}

/**
 * Makes the Back key or gesture of a phone close an open part of the page first, instead of leaving the page. Where the
 * browser does not support it, Back goes back.
 * @returns a function that ends this.
 */
export function onBackKey(close: () => void): () => void {
  const watcher = tried(() => {
    const Watcher = service('CloseWatcher');
    const made = Watcher && new Watcher();
    made?.addEventListener('close', close);
    return made;
  });
  return () => tried(() => watcher?.destroy());
}

/** What Back in the history closes, the topmost last. */
const parts: (() => void)[] = [];

/**
 * Makes Back in the history of the browser call `close`, which may refuse, instead of going to another view. A
 * browser keeps its own list for the Back key of a phone, see {@link onBackKey}.
 * @returns a function that ends this.
 */
export function onBackInHistory(close: () => void): () => void {
  // The same function may be given twice.
  const part = (): void => close();
  parts.push(part);
  return () => void parts.splice(parts.indexOf(part), 1);
}

/** Tells the topmost open part that Back was pressed. @returns whether there is one. */
export function takeBack(): boolean {
  const part = parts.at(-1);
  part?.();
  return part !== undefined;
}
