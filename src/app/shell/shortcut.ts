import { tried } from '../browser/services.js';

/**
 * Follows a shortcut of the installed page. public/manifest.webmanifest gives it a name in the address, and a button or
 * card has the same name as `data-lead`. It only puts the focus there: the pilot opens a port with a press of his own.
 * The name leaves the address, so that a reload does not follow it again.
 * @returns a function that follows it. Call it again when stored work has come to the screen, unless the pilot has gone
 * elsewhere.
 */
export function shortcutOf({
  location,
  history,
  document,
}: Pick<Window, 'location' | 'history' | 'document'>): () => void {
  const address = new URL(location.href);
  const name = address.searchParams.get('do');
  if (name === null) return () => {};
  address.searchParams.delete('do');
  tried(() => history.replaceState(history.state, '', address));
  return () => {
    if (document.activeElement !== null && document.activeElement !== document.body) return;
    const places = [...document.querySelectorAll<HTMLElement>('[data-lead]')];
    const place = places.find((each) => each.getAttribute('data-lead') === name);
    place?.scrollIntoView?.({ block: 'nearest' });
    (place?.querySelector('button') ?? place)?.focus({ preventScroll: true });
  };
}
