import { signal } from '@preact/signals';
import { fireEvent, screen } from '@testing-library/preact';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { Platform } from '../../../src/app/browser/platform.js';
import { Installation } from '../../../src/app/connect/installation.js';
import { idle, run } from '../bench/bench.js';
import { button, connected, press, type } from '../screen.js';

const CHROME: Platform = { system: 'windows', browser: 'chrome', version: 140, mobile: false };
const IPHONE: Platform = { system: 'ios', browser: 'safari', version: 18, mobile: true };
const SAFARI: Platform = { system: 'mac', browser: 'safari', version: 17, mobile: false };
const FIREFOX: Platform = { system: 'windows', browser: 'firefox', version: 152, mobile: false };

const clear = (): void => {
  localStorage.clear();
  sessionStorage.clear();
};
beforeEach(clear);
afterEach(() => {
  clear();
  vi.unstubAllGlobals();
});

/** A browser comes back to the page: what is kept for one tab is gone. */
function visit(platform: Platform, proven = signal(false)): Installation {
  sessionStorage.clear();
  return new Installation(platform, proven);
}

/** The browser says that the page can be installed. */
function offer(installation: Installation): EventTarget {
  const window = new EventTarget();
  installation.follow(window);
  window.dispatchEvent(Object.assign(new Event('beforeinstallprompt'), { prompt: async () => {} }));
  return window;
}

describe('the hint that the page can be installed', () => {
  it('comes with the second visit, and not with a reload of the first', () => {
    const first = visit(CHROME);
    offer(first);
    expect(first.hint.value).toBeNull();
    const reloaded = new Installation(CHROME, signal(false));
    offer(reloaded);
    expect(reloaded.hint.value).toBeNull();
    const second = visit(CHROME);
    offer(second);
    expect(second.hint.value).toBe('button');
  });

  it('comes with the first write that was verified', () => {
    const proven = signal(false);
    const installation = visit(CHROME, proven);
    offer(installation);
    proven.value = true;
    expect(installation.hint.value).toBe('button');
    proven.value = false;
    expect(installation.hint.value).toBe('button');
  });

  it('is shown in one visit only, and not again when it was dismissed, used, or followed elsewhere', () => {
    const ends: ((installation: Installation, window: EventTarget) => void)[] = [
      (installation) => installation.endHint(),
      (installation) => installation.install.value?.(),
      (_, window) => window.dispatchEvent(new Event('appinstalled')),
    ];
    for (const end of ends) {
      clear();
      visit(CHROME);
      const second = visit(CHROME);
      const window = offer(second);
      expect(second.hint.value).toBe('button');
      second.told();
      end(second, window);
      expect(second.hint.value).toBeNull();
      const third = visit(CHROME);
      offer(third);
      expect(third.hint.value).toBeNull();
    }
  });

  it.each([
    ['Chrome that offers nothing', CHROME, null],
    ['Firefox', FIREFOX, null],
    ['an iPhone', IPHONE, 'share'],
    ['Safari on a Mac', SAFARI, 'dock'],
    ['an older Safari on a Mac', { ...SAFARI, version: 16 }, null],
  ] as const)('has the right words, or none: %s', (_, platform, way) => {
    visit(platform);
    expect(visit(platform).hint.value).toBe(way);
  });

  it('is not shown on an installed page', () => {
    visit(IPHONE);
    vi.stubGlobal('matchMedia', (query: string) => ({ matches: query === '(display-mode: standalone)' }));
    const installed = visit(IPHONE);
    installed.follow(new EventTarget());
    expect(installed.hint.value).toBeNull();
  });

  it('waits until the timer is gone, and goes for good with “Not now”', async () => {
    const { session, models } = await connected();
    offer(models.installation);
    await type('DT time', '4:00');
    await press('Write…');
    fireEvent.click(screen.getByRole('checkbox', { name: /^The propeller is off/ }));
    await idle(0);
    await press(/^Write 1 change$/);
    await press('Close');
    expect(screen.queryByText('Install Sidus Timer.')).toBeNull();
    await run(session.timer.disconnect());
    await idle(0);
    expect(screen.getByText('Install Sidus Timer.')).toBeTruthy();
    expect(localStorage.getItem('sidus-timer/install-hint')).toBe('true');
    fireEvent.click(button('Not now'));
    await idle(0);
    expect(screen.queryByText('Install Sidus Timer.')).toBeNull();
  });
});
