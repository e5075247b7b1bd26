import { useEffect } from 'preact/hooks';

/**
 * Releases what is pressed when the page can no longer hear the end of the press: another window or tab has come before
 * it, or the button is gone.
 */
export function useRelease(press: { release(): void }): void {
  useEffect(() => {
    const release = (): void => press.release();
    addEventListener('blur', release);
    document.addEventListener('visibilitychange', release);
    return () => {
      release();
      removeEventListener('blur', release);
      document.removeEventListener('visibilitychange', release);
    };
  }, [press]);
}
