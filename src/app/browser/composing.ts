/** The code of each key that goes to the composing of a text. A phone gives Enter its own code all the same. */
const COMPOSED = 229;

/**
 * Keeps from the page the keys with which a pilot composes a text: Enter takes a proposal, and the arrows go from one
 * to the next. They mean neither the next cell nor the chosen command.
 */
export function leaveComposing(window: Window): void {
  const leave = (event: KeyboardEvent): void => {
    if (event.keyCode === COMPOSED) event.stopPropagation();
  };
  window.addEventListener('keydown', leave, { capture: true });
}
