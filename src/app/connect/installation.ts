import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { media } from '../browser/doors.js';
import type { Platform } from '../browser/platform.js';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** The event with which a browser offers to install the page. The types of the DOM do not have it. */
interface InstallEvent extends Event {
  prompt(): Promise<unknown>;
}

/** How to install the page here: a button of the page, or a command of the browser. */
export type InstallWay = 'button' | 'share' | 'dock';

/** The first Safari that can put pages into the Dock of a Mac. */
const DOCK_SAFARI = 17;

/** The page as an app of this device: whether it works without a network, and how to install it. */
export class Installation {
  readonly #ready = signal(false, { name: 'readyOffline' });
  readonly #install = signal<(() => void) | null>(null, { name: 'install' });
  readonly #hint = signal<'early' | 'due' | 'over'>('early', { name: 'installHint' });
  readonly #platform: Platform;
  /** Whether the whole page is kept for use without a network. */
  readonly ready: ReadonlySignal<boolean> = this.#ready;
  /** Lets the browser ask whether to install the page; null where it does not offer that, or the page is installed. */
  readonly install: ReadonlySignal<(() => void) | null> = this.#install;
  /** How to tell the pilot, once, that the page can be installed; null before the right time, and afterwards. */
  readonly hint: ReadonlySignal<InstallWay | null> = computed(() => (this.#hint.value === 'due' ? this.#way() : null));

  /** @param proven whether a write to a timer was verified: then the pilot knows what the page is good for. */
  constructor(platform: Platform, proven: ReadonlySignal<boolean>) {
    this.#platform = platform;
    if (loadSetting('install-hint', v.boolean()) === true) this.#hint.value = 'over';
    else if (isLaterVisit()) this.#hint.value = 'due';
    effect(() => {
      if (proven.value && this.#hint.peek() === 'early') this.#hint.value = 'due';
    });
  }

  readonly isKept = (): void => {
    this.#ready.value = true;
  };

  /** The hint is on the screen. It is shown in one visit only, whatever the pilot does with it. */
  told(): void {
    saveSetting('install-hint', true);
  }

  /** The pilot has seen the hint. */
  endHint(): void {
    this.#hint.value = 'over';
  }

  /** Listens for what the browser offers. */
  follow(window: Pick<EventTarget, 'addEventListener'>): void {
    if (media('(display-mode: standalone)')?.matches) this.#hint.value = 'over';
    window.addEventListener('beforeinstallprompt', (event) => {
      // The browser must ask only when the pilot wants it, not over the table.
      event.preventDefault();
      this.#install.value = () => {
        this.#install.value = null;
        this.endHint();
        void (event as InstallEvent).prompt().catch(() => {});
      };
    });
    window.addEventListener('appinstalled', () => {
      this.#install.value = null;
      this.endHint();
    });
  }

  /** Null where there is no way, or none is known: then there is no hint. */
  #way(): InstallWay | null {
    const { system, browser, version } = this.#platform;
    if (this.#install.value) return 'button';
    if (system === 'ios') return 'share';
    return system === 'mac' && browser === 'safari' && (version ?? 0) >= DOCK_SAFARI ? 'dock' : null;
  }
}

/** Whether the page was opened on this device before. A reload does not count as another visit. */
function isLaterVisit(): boolean {
  const before = loadSetting('visited', v.boolean()) === true;
  const isLater = loadSetting('visited', v.boolean(), 'sessionStorage') ?? before;
  saveSetting('visited', isLater, 'sessionStorage');
  saveSetting('visited', true);
  return isLater;
}
