import '@fontsource-variable/inter/wght.css';
import './ui/fonts.css';
import './ui/tokens.css';
import './ui/base.css';
import './ui/shared.css';
// The styles of the first picture.
import './app.css';
import './shell/header.css';
import './shell/status-strip.css';
import './connect/start-screen.css';
import './connect/start-cards.css';
import './connect/step-list.css';
import './timeline/picture.css';
import './timeline/small-lanes.css';
import { effect } from '@preact/signals';
import { afterPaint, nextTask } from './browser/after-paint.js';
import { media } from './browser/doors.js';
import { holdDroppedFiles } from './browser/dropped-files.js';
import { tried } from './browser/services.js';
import { earlyClicks } from './early-clicks.js';
import firstTexts from './first-picture.json';
import { changeTexts } from './first-texts.js';
import { chooseLanguage, firstOf, preferredLanguage } from './messages/first.js';
import { language, speak } from './messages/language.js';
import './messages/page.js';
import { Theme } from './settings/theme.js';

/*
 * Everything before the first picture. The start stands in index.html. Here it gets its colours; once it is drawn, the
 * page itself is loaded and takes its place.
 */
/** Milliseconds after which the page says that it is still loading. A browser may wait minutes for an answer. */
const SLOW = 15_000;
document.querySelector('.not-started')?.remove();
const root = document.getElementById('app') as HTMLElement;
const theme = new Theme();
tried(() => theme.follow(document, media('(prefers-color-scheme: dark)')));
let preferred = tried(preferredLanguage) ?? 'en';
// Inside another page, or at the address of another view, something else will be shown.
const isStart = window.top === window.self && ['', '#program'].includes(location.hash);
if (!isStart) root.replaceChildren();
if (preferred !== 'en') sayFirstPicture(preferred);
root.hidden = false;
holdDroppedFiles();
let notice: HTMLElement | null = null;
const doEarlyClick = earlyClicks(root);
root.addEventListener('change', chooseEarly);
// The browser's languages were changed in its settings. A chosen one stays.
window.addEventListener('languagechange', () => {
  preferred = preferredLanguage();
  void speak(preferred).catch(() => {});
});
// Without a first picture there is nothing to wait for.
if (isStart) afterPaint(open);
else void open();

async function open(): Promise<void> {
  const slow = setTimeout(offerReload, SLOW);
  try {
    const [{ openPage }] = await Promise.all([import('./open-page.js'), speak(preferred).catch(() => speak('en'))]);
    effect(() => sayLanguage(language.value));
    await nextTask();
    await openPage(root, theme);
    // From here on the page itself listens.
    root.removeEventListener('change', chooseEarly);
    notice?.remove();
    doEarlyClick();
  } catch (error) {
    offerReload();
    throw error;
  } finally {
    clearTimeout(slow);
  }
}

/** The picture has one choice: the language. The page is to be in it when it comes. */
function chooseEarly({ target }: Event): void {
  preferred = (target as HTMLSelectElement).value;
  void chooseLanguage(preferred).catch(() => {});
}

/** The picture is in English. */
function sayFirstPicture(code: string): void {
  sayLanguage(code);
  const texts: Readonly<Record<string, readonly string[]>> = firstTexts;
  const said = texts[code]?.values();
  changeTexts(root, (text) => said?.next().value ?? text);
  const choice = root.querySelector('select');
  if (choice) choice.value = code;
}

/** Says to the browser what the page speaks: for its voice and hyphens, and to the system that installs the page. */
function sayLanguage(code: string): void {
  document.documentElement.lang = code;
  const manifest = document.querySelector<HTMLLinkElement>('link[rel="manifest"]');
  if (manifest) manifest.href = code === 'en' ? './manifest.webmanifest' : `./manifest.${code}.webmanifest`;
}

/** Says that something is missing, with a button to load the page again: it has no other sentences or parts yet. */
function offerReload(): void {
  notice ??= document.createElement('p');
  notice.role = 'alert';
  notice.className = 'notice bad';
  const again = document.createElement('button');
  const first = firstOf(preferred);
  again.textContent = first.again;
  again.addEventListener('click', () => location.reload());
  notice.replaceChildren(first.failed, ' ', again);
  document.body.prepend(notice);
}
