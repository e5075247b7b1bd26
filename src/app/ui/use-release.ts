import { useEffect } from 'preact/hooks';
import { on } from '../browser/lifecycle.js';

/**
 * Releases what is pressed when the page can no longer hear the end of the press: another window or tab has come before
 * it, or the button is gone.
 */
export function useRelease(press: { release(): void }): void {
  useEffect(() => {
    const release = (): void => press.release();
    const end = on('away', release);
    return () => {
      release();
      end();
    };
  }, [press]);
}
