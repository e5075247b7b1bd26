import { tried } from '../browser/services.js';

/**
 * Where a shortcut of the installed page leads: public/manifest.webmanifest names it in the address, and the button or
 * the card that is meant has that name as `data-lead`. Nothing is done there: what opens a port is pressed by the
 * pilot. The address forgets the name, so that a reload does not lead there again.
 * @returns leads there; again, when what was kept has come to the screen, and the pilot has not gone elsewhere.
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
