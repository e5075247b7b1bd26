import { describe, expect, it } from 'vitest';
import { Sharing } from '../../../../src/app/library/share/sharing.js';
import { Views } from '../../../../src/app/shell/views.js';

/** A window with an address and a history that can be read. */
function windowAt(hash: string) {
  const events = new EventTarget();
  const entries = [hash];
  const location = { hash } as Location;
  const arriveAt = (to: string): void => {
    location.hash = to;
    entries.push(to);
  };
  return {
    location,
    history: {
      pushState: (_: unknown, __: string, to: string) => arriveAt(to),
      replaceState: (_: unknown, __: string, to?: string) => {
        if (to === undefined) return;
        entries.pop();
        arriveAt(to);
      },
    } as History,
    addEventListener: events.addEventListener.bind(events) as Window['addEventListener'],
    removeEventListener: events.removeEventListener.bind(events) as Window['removeEventListener'],
    entries,
    goTo(to: string) {
      arriveAt(to);
      for (const type of ['popstate', 'hashchange']) events.dispatchEvent(new Event(type));
    },
  };
}

function opened(hash: string) {
  const window = windowAt(hash);
  const views = new Views();
  const sharing = new Sharing();
  const ends = [views.follow(window), sharing.follow(window, () => views.address)];
  const end = (): void => {
    for (const each of ends) each();
  };
  return { window, views, sharing, end };
}

describe('a link in the address', () => {
  it('is shown when the page is opened with it, and not again after the answer', () => {
    const { window, views, sharing } = opened('#s=AAAA');
    expect(sharing.current.value).toEqual({ step: 'received', link: '#s=AAAA' });
    expect([views.shown.value, window.entries]).toEqual(['program', ['#s=AAAA']]);
    sharing.close();
    expect([sharing.current.value, window.entries]).toEqual([null, ['#program']]);
    sharing.close();
    expect(window.entries, 'closing it once more changes nothing').toEqual(['#program']);
  });

  it('is shown over the present view, also when the page is already open', () => {
    const { window, views, sharing } = opened('#library/none');
    window.goTo('#s=BBBB');
    expect(sharing.current.value).toEqual({ step: 'received', link: '#s=BBBB' });
    expect([views.shown.value, views.path.value]).toEqual(['library', 'none']);
    sharing.close();
    expect(window.entries).toEqual(['#library/none', '#library/none']);
    views.show('memories');
    expect(window.entries.at(-1)).toBe('#memories');
  });

  it('is replaced by a later one, and does not change the view that the pilot has opened meanwhile', () => {
    const { window, sharing } = opened('#s=AAAA');
    window.goTo('#s=CCCC');
    expect(sharing.current.value).toEqual({ step: 'received', link: '#s=CCCC' });
    window.goTo('#memories');
    sharing.close();
    expect(window.location.hash).toBe('#memories');
  });

  it('is shown also when a program has put its signs in percent coding', () => {
    const { window, sharing } = opened('#s%3DAAAA');
    expect(sharing.current.value).toEqual({ step: 'received', link: '#s%3DAAAA' });
    sharing.close();
    expect(window.location.hash).toBe('#program');
    window.goTo('#library/x#s=AAAA');
    expect(sharing.current.value, 'it does not begin with a link').toBeNull();
  });

  it('is ignored once the page no longer listens, and other addresses are ignored too', () => {
    const { window, sharing, end } = opened('#settings');
    expect(sharing.current.value).toBeNull();
    window.goTo('#memories');
    expect(sharing.current.value).toBeNull();
    end();
    window.goTo('#s=AAAA');
    expect(sharing.current.value).toBeNull();
  });
});
