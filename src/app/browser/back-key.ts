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
