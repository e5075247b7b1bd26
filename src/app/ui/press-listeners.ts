/** The listeners of a button that acts while it is pressed. */
export interface PressListeners {
  readonly onPointerDown: (event: PointerEvent) => void;
  readonly onPointerMove: (event: PointerEvent) => void;
  readonly onPointerUp: () => void;
  readonly onPointerLeave: () => void;
  readonly onPointerCancel: () => void;
  readonly onContextMenu: (event: Event) => void;
}

/**
 * Tells when the finger, the pen or the main button of the mouse presses a button, and when it no longer does.
 * A long press brings no menu, which would hide the release.
 */
export function pressListeners(press: () => void, release: () => void): PressListeners {
  return {
    onPointerDown: ({ button, isPrimary }) => {
      if (button === 0 && isPrimary !== false) press();
    },
    // While another button of the mouse is down, the release of the main one comes as a move.
    onPointerMove: ({ buttons }) => {
      if ((buttons & 1) === 0) release();
    },
    onPointerUp: release,
    onPointerLeave: release,
    onPointerCancel: release,
    onContextMenu: (event) => event.preventDefault(),
  };
}
