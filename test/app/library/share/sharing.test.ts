import { describe, expect, it } from 'vitest';
import { Sharing } from '../../../../src/app/library/share/sharing.js';
import { Views } from '../../../../src/app/shell/views.js';
import { historyFrom } from '../../history.js';

function opened(hash: string) {
  const past = historyFrom(hash);
  const { window } = past;
  const views = new Views();
  const sharing = new Sharing();
  const ends = [views.follow(window), sharing.follow(window, () => views.address)];
  const end = (): void => {
    for (const each of ends) each();
  };
  return { ...past, views, sharing, end };
}

describe('a link in the address', () => {
  it('is shown when the page is opened with it, and not again after the answer', () => {
    const { shown, views, sharing } = opened('#s=AAAA');
    expect(sharing.current.value).toEqual({ step: 'received', link: '#s=AAAA' });
    expect([views.shown.value, shown()]).toEqual(['program', ['#s=AAAA']]);
    sharing.close();
    expect([sharing.current.value, shown()]).toEqual([null, ['#program']]);
    sharing.close();
    expect(shown(), 'closing it once more changes nothing').toEqual(['#program']);
  });

  it('is shown over the present view, also when the page is already open', () => {
    const { enter, shown, views, sharing } = opened('#library/none');
    enter('#s=BBBB');
    expect(sharing.current.value).toEqual({ step: 'received', link: '#s=BBBB' });
    expect([views.shown.value, views.path.value]).toEqual(['library', 'none']);
    sharing.close();
    expect(shown()).toEqual(['#library/none', '#library/none']);
    views.show('memories');
    expect(shown().at(-1)).toBe('#memories');
  });

  it('is replaced by a later one, and does not change the view that the pilot has opened meanwhile', () => {
    const { enter, window, sharing } = opened('#s=AAAA');
    enter('#s=CCCC');
    expect(sharing.current.value).toEqual({ step: 'received', link: '#s=CCCC' });
    enter('#memories');
    sharing.close();
    expect(window.location.hash).toBe('#memories');
  });

  it('is shown also when a program has put its signs in percent coding', () => {
    const { enter, window, sharing } = opened('#s%3DAAAA');
    expect(sharing.current.value).toEqual({ step: 'received', link: '#s%3DAAAA' });
    sharing.close();
    expect(window.location.hash).toBe('#program');
    enter('#library/x#s=AAAA');
    expect(sharing.current.value, 'it does not begin with a link').toBeNull();
  });

  it('is ignored once the page no longer listens, and other addresses are ignored too', () => {
    const { enter, sharing, end } = opened('#settings');
    expect(sharing.current.value).toBeNull();
    enter('#memories');
    expect(sharing.current.value).toBeNull();
    end();
    enter('#s=AAAA');
    expect(sharing.current.value).toBeNull();
  });
});
