import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { media } from '../browser/doors.js';
import type { Platform } from '../browser/platform.js';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** What a browser hands out that can install the page; it is not in the types of the DOM. */
interface InstallEvent extends Event {
  prompt(): Promise<unknown>;
}

/** How the page is installed here: by a button of its own, or by a command of the browser. */
export type InstallWay = 'button' | 'share' | 'dock';

/** The first Safari that puts pages into the Dock of a Mac. */
const DOCK_SAFARI = 17;

/** The page as a program of this device: whether it works without a network, and how it is installed. */
export class Installation {
  readonly #ready = signal(false, { name: 'readyOffline' });
  readonly #install = signal<(() => void) | null>(null, { name: 'install' });
  readonly #hint = signal<'early' | 'due' | 'over'>('early', { name: 'installHint' });
  readonly #platform: Platform;
  /** Whether all of the page is kept for use without a network. */
  readonly ready: ReadonlySignal<boolean> = this.#ready;
  /** Lets the browser ask whether the page is to be installed; null where that is not offered, or was done. */
  readonly install: ReadonlySignal<(() => void) | null> = this.#install;
  /** How to tell the pilot, once, that the page can be installed; null before the time, and after. */
  readonly hint: ReadonlySignal<InstallWay | null> = computed(() => (this.#hint.value === 'due' ? this.#way() : null));

  /** @param proven whether a write to a timer was verified: then the page has shown what it is good for. */
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

  /** The hint is on the screen: it is so in one visit alone, whatever the pilot does with it. */
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
      // It asks when the pilot says so, and not over the table.
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

  /** Null where there is none, or where it is not known: then nothing is said. */
  #way(): InstallWay | null {
    const { system, browser, version } = this.#platform;
    if (this.#install.value) return 'button';
    if (system === 'ios') return 'share';
    return system === 'mac' && browser === 'safari' && (version ?? 0) >= DOCK_SAFARI ? 'dock' : null;
  }
}

/** Whether the page was opened on this device before. A reload is no other visit. */
function isLaterVisit(): boolean {
  const before = loadSetting('visited', v.boolean()) === true;
  const isLater = loadSetting('visited', v.boolean(), 'sessionStorage') ?? before;
  saveSetting('visited', isLater, 'sessionStorage');
  saveSetting('visited', true);
  return isLater;
}
