import { effect } from '@preact/signals';
import { render } from 'preact';
import { App } from './app.js';
import { afterPaint, nextTask } from './browser/after-paint.js';
import { leaveComposing } from './browser/composing.js';
import { type Lack, surroundings } from './browser/doors.js';
import { askBeforeLeaving, on } from './browser/lifecycle.js';
import { registerOffline } from './browser/offline.js';
import { OneTab } from './browser/one-tab.js';
import { platformOf } from './browser/platform.js';
import { nameplate, service, tried } from './browser/services.js';
import { keepsSettings } from './browser/settings.js';
import { clockText } from './messages/index.js';
import { followDay } from './messages/today.js';
import { createModels } from './models.js';
import { fetchParts, fetchSimulated } from './parts.js';
import { browserErasers } from './settings/erasers.js';
import type { Theme } from './settings/theme.js';
import { FramedPage, isFramed } from './shell/framed-page.js';
import { OtherTabPage } from './shell/other-tab-page.js';
import { shortcutOf } from './shell/shortcut.js';
import { browserStorage } from './storage/index.js';
import type { Session } from './work/session.js';

/**
 * Draws the page, then asks the browser for everything that takes time. Nothing that the browser lacks, refuses or
 * never answers prevents the drawing.
 * @param theme the theme of the first picture.
 */
export async function openPage(root: HTMLElement, theme: Theme): Promise<void> {
  if (isFramed(window)) {
    render(<FramedPage address={location.href} />, root);
    return;
  }
  const tab = new OneTab();
  // What a pilot opens next, perhaps this page again, must not wait for it.
  on('leave', () => tab.end());
  on('restore', () => location.reload());
  const begun = await tab.begin();
  if (begun !== 'other') return await work(root, theme, tab, begun === 'unknown' ? ['tabs'] : []);
  render(<OtherTabPage tab={tab} />, root);
  // Another version may have come while this tab waited. It has all its files only after a reload.
  const newer = new AbortController();
  tried(() => service('serviceWorker')?.addEventListener('controllerchange', () => location.reload(), newer));
  void tab.free.then(() => {
    newer.abort();
    return work(root, theme, tab);
  });
}

/** The page of the one tab that works. */
async function work(root: HTMLElement, theme: Theme, tab: OneTab, lacks: readonly Lack[] = []): Promise<void> {
  const models = createModels({
    surroundings: surroundings(),
    storage: browserStorage(undefined, () => keeping.lack('emptied')),
    plugSimulated: async (timerClass) => (await fetchSimulated()).plugSimulatedTimer(timerClass),
    plugRecording: async (entries) => (await fetchSimulated()).plugRecording(entries),
    platform: platformOf(nameplate()),
    lacks: keepsSettings() ? lacks : [...lacks, 'settings'],
    erasers: browserErasers(service('serial')),
    reload: () => location.reload(),
    theme,
  });
  const { session, views, sharing, follow, update, keeping, installation } = models;
  // Long work on a slow device comes in pieces, so that the page hears the pilot between them.
  await nextTask();
  installation.follow(window);
  const lead = tried(() => shortcutOf(window)) ?? (() => {});
  tried(() => views.follow(window));
  // Thousands of settings are read while their view is being loaded.
  if (views.shown.value === 'library') void session.library.load();
  tried(() => sharing.follow(window, () => views.address));
  leaveComposing(window);
  render(<App models={models} />, root);
  lead();
  void session.keptWork.start().then(lead);
  afterPaint(() => void fetchParts().then(() => getReady(session)));

  tab.work(
    () => session.runner.job.peek()?.asking === false,
    async () => {
      session.keptWork.keepNow();
      await session.runner.still();
      await session.timer.disconnect();
      location.reload();
    },
  );
  // Leaving the page during a write is the one thing that a reload cannot repair.
  effect(() => askBeforeLeaving(session.runner.writing.value));
  keeping.onKept(() =>
    tried(() =>
      service('storage')
        ?.persist()
        .catch(() => {}),
    ),
  );
  on('hide', () => {
    session.keptWork.keepNow();
    void follow.stop('over');
  });
  on('leave', () => {
    session.backups.flush();
    session.library.flush();
  });
  // Room is made in another window, or in the settings of a phone.
  on('return', () => keeping.tryAgain());
  on('wake', () => session.link.recheck());
  followDay();
  tried(() => registerOffline({ onUpdateReady: update.offer, whenFree: update.whenFree, onKept: installation.isKept }));
}

/** Does what takes long before the pilot waits for it. */
function getReady({ library }: Session): void {
  // The browser needs about 10 ms to format its first time of day: the table of a timer would wait for it.
  clockText(Date.now());
  // There can be thousands of flights, and the log opens at once.
  void library.flights.load();
}
