import { service, tried } from './services.js';

/** As much of it as is used here: TypeScript does not know it yet. */
interface CloseWatcherLike {
  addEventListener(type: 'close', listener: () => void): void;
  destroy(): void;
}

declare global {
  var CloseWatcher: { readonly prototype: CloseWatcherLike; new (): CloseWatcherLike };
}

/**
 * The Back key of a phone, or the gesture, first closes what has come up, as it puts away a keyboard, and does not
 * leave the page. Where a browser tells nothing of it, it goes back.
 * @returns a function that ends it.
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
