import { effect } from '@preact/signals';
import { render } from 'preact';
import { App } from './app.js';
import { afterPaint, nextTask } from './browser/after-paint.js';
import { lacksOf, media, openDoors, tabNumberOf } from './browser/doors.js';
import { registerOffline } from './browser/offline.js';
import { platformOf } from './browser/platform.js';
import { nameplate, service, tried } from './browser/services.js';
import { onWake } from './browser/wake.js';
import { createModels } from './models.js';
import { fetchParts, fetchSimulated } from './parts.js';
import { TABLET } from './settings/density.js';
import { browserErasers } from './settings/erasers.js';
import type { Theme } from './settings/theme.js';
import { FramedPage, isFramed } from './shell/framed-page.js';
import { shortcutOf } from './shell/shortcut.js';
import { browserStorage } from './storage/index.js';

/**
 * Draws the page, then asks the browser for whatever takes its time. Nothing that the browser does not have, refuses or
 * never answers keeps the page from being drawn.
 * @param theme in which the first picture was drawn.
 */
export async function openPage(root: HTMLElement, theme: Theme): Promise<void> {
  if (isFramed(window)) {
    render(<FramedPage address={location.href} />, root);
    return;
  }
  const doors = openDoors();
  const models = createModels({
    surroundings: doors.surroundings,
    storage: browserStorage(),
    tab: tabNumberOf(doors),
    plugSimulated: async (timerClass) => (await fetchSimulated()).plugSimulatedTimer(timerClass),
    plugRecording: async (entries) => (await fetchSimulated()).plugRecording(entries),
    platform: platformOf(nameplate()),
    channel: doors.channel,
    libraryChannel: doors.libraryChannel,
    lacks: lacksOf(doors),
    erasers: browserErasers(service('serial')),
    reload: () => location.reload(),
    theme,
  });
  const { session, views, sharing, follow, update, keeping, density, installation } = models;
  // What a slow device needs some time for comes in pieces: what is touched meanwhile is heard between them.
  await nextTask();
  installation.follow(window);
  const lead = tried(() => shortcutOf(window)) ?? (() => {});
  tried(() => views.follow(window));
  // Thousands of settings are read while the view that shows them is fetched.
  if (views.shown.value === 'library') void session.library.load();
  tried(() => sharing.follow(window, () => views.address));
  tried(() => density.follow(document, media(TABLET)));
  render(<App models={models} />, root);
  lead();
  void session.keptWork.start().then(lead);
  // Thousands of flights take their time: they are here before the log is looked at.
  afterPaint(() => void fetchParts().then(() => session.library.flights.load()));

  const warn = (event: BeforeUnloadEvent): void => event.preventDefault();
  effect(() => {
    // Leaving in the middle of a write is the one thing that a reload cannot mend by itself.
    if (session.runner.writing.value) addEventListener('beforeunload', warn);
    else removeEventListener('beforeunload', warn);
  });
  keeping.onKept(() =>
    tried(() =>
      service('storage')
        ?.persist()
        .catch(() => {}),
    ),
  );
  document.addEventListener('visibilitychange', () => document.hidden && void follow.stop('hidden'));
  addEventListener('pagehide', () => {
    session.keptWork.keepNow();
    session.backups.flush();
    session.library.flush();
  });
  // A page that is put away on a phone may be ended without another word.
  document.addEventListener('visibilitychange', () => {
    if (!document.hidden) return;
    session.keptWork.keepNow();
    session.library.keepClashes();
  });
  // What another tab has found out, or left behind, since this one was looked at last.
  document.addEventListener('visibilitychange', () => document.hidden || void session.knowledge.refresh());
  onWake(() => session.link.recheck());
  const onMissing = (): void => keeping.lack('offline');
  try {
    const { isKept: onKept } = installation;
    registerOffline({ onUpdateReady: update.offer, whenFree: update.whenFree, onKept, onMissing });
  } catch {
    onMissing();
  }
}
