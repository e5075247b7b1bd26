import type { ButtonHTMLAttributes } from 'preact';
import { useEffect } from 'preact/hooks';
import { on } from '../browser/lifecycle.js';

/**
 * The listeners of a button that acts while it is pressed: they tell when the finger, the pen or the main button of the
 * mouse presses it, and when it no longer does. That is also when the page can no longer hear the end of the press:
 * another window or tab has come before it, or the button is gone.
 * @param press what may be released without having been pressed.
 */
export function usePress(press: { release(): void }, onPress: () => void): ButtonHTMLAttributes<HTMLButtonElement> {
  const release = (): void => press.release();
  useEffect(() => {
    const end = on('away', release);
    return () => {
      release();
      end();
    };
  }, [press]);
  return {
    onPointerDown: ({ button, isPrimary }) => {
      if (button === 0 && isPrimary !== false) onPress();
    },
    // While another button of the mouse is down, the release of the main one comes as a move.
    onPointerMove: ({ buttons }) => {
      if ((buttons & 1) === 0) release();
    },
    onPointerUp: release,
    onPointerLeave: release,
    onPointerCancel: release,
    // A long press brings no menu, which would hide the release.
    onContextMenu: (event) => event.preventDefault(),
  };
}
