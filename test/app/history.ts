import type { AddressWindow } from '../../src/app/shell/views.js';

/** A window with a history of its own: Back and Forward go through it at once. */
export function historyFrom(...hashes: string[]) {
  const entries = hashes.map((hash) => ({ hash, state: 'seen' as unknown }));
  let at = entries.length - 1;
  const heard = new EventTarget();
  const go = (by: number): void => {
    at += by;
    for (const type of ['popstate', 'hashchange']) heard.dispatchEvent(new Event(type));
  };
  const window = {
    get location() {
      return { hash: entries[at]?.hash };
    },
    history: {
      get state() {
        return entries[at]?.state;
      },
      pushState: (state: unknown, _title: string, hash: string) => {
        entries.splice(++at, Number.POSITIVE_INFINITY, { hash, state });
      },
      replaceState: (state: unknown, _title: string, hash = entries[at]?.hash) =>
        Object.assign(entries[at] ?? {}, { state, hash }),
    },
    addEventListener: heard.addEventListener.bind(heard),
    removeEventListener: heard.removeEventListener.bind(heard),
  } as unknown as AddressWindow;
  const enter = (hash: string): void => {
    entries.splice(at + 1, Number.POSITIVE_INFINITY, { hash, state: null });
    go(1);
  };
  const shown = () => entries.slice(0, at + 1).map(({ hash }) => hash);
  return { window, back: () => go(-1), forward: () => go(1), enter, shown };
}
