// Finds a Chromium for the tests, or installs one.
// As a program (`node test/tools/browser.js`) it does both and prints where the browser is.

import { execFileSync } from 'node:child_process';
import { accessSync, constants, existsSync } from 'node:fs';
import process, { env, platform, stderr } from 'node:process';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright';

const { CHROME_PATH, HOME, LOCALAPPDATA, PROGRAMFILES } = env;

/** @type {Partial<Record<NodeJS.Platform, (string | undefined)[]>>} */
const usualPlaces = {
  linux: [
    '/usr/bin/chromium',
    '/usr/bin/google-chrome-stable',
    '/usr/bin/google-chrome',
    '/opt/google/chrome/chrome',
    '/usr/bin/chromium-browser',
    '/snap/bin/chromium',
  ],
  darwin: ['', HOME].flatMap((home) => [
    `${home}/Applications/Google Chrome.app/Contents/MacOS/Google Chrome`,
    `${home}/Applications/Chromium.app/Contents/MacOS/Chromium`,
  ]),
  win32: [PROGRAMFILES, env['PROGRAMFILES(X86)'], LOCALAPPDATA].map(
    (folder) => folder && `${folder}\\Google\\Chrome\\Application\\chrome.exe`,
  ),
};

/** @param {string | undefined} path */
function isProgram(path) {
  try {
    accessSync(path ?? '', constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/**
 * The installed browser: the one CHROME_PATH names, else one in the usual places, else Playwright's own.
 * @returns {string | undefined} its path
 */
export function findBrowser() {
  if (CHROME_PATH && !isProgram(CHROME_PATH)) throw new Error(`CHROME_PATH is ${CHROME_PATH}, where no program is.`);
  if (CHROME_PATH) return CHROME_PATH;
  return [...(usualPlaces[platform] ?? []), chromium.executablePath()].find(isProgram);
}

/** Installs a browser: Debian's where possible, else Playwright's own. */
function installBrowser() {
  /** @param {string} program @param {string[]} args */
  const run = (program, ...args) => {
    stderr.write(`> ${program} ${args.join(' ')}\n`);
    const options = { env: { ...env, DEBIAN_FRONTEND: 'noninteractive' }, shell: platform === 'win32' };
    execFileSync(program, args, { ...options, stdio: ['ignore', 2, 2] });
  };
  stderr.write('The tests need Chrome or Chromium, and none is here: installing one.\n');
  if (existsSync('/etc/debian_version') && process.getuid?.() === 0) {
    run('apt-get', 'update', '-q');
    run('apt-get', 'install', '-q', '-y', '--no-install-recommends', 'chromium');
  } else {
    run('npx', 'playwright', 'install', 'chromium');
  }
}

/** The switches of the browser: no sandbox for root, because root cannot have one, and no calls to its maker. */
export const browserArgs = [
  ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-quic',
];

/**
 * What the browser does not do in tests. Chromium loads two own pages beside each window, for the list under the
 * address bar: they take as much time as a page of ours. The last switch of this name counts, so what Playwright would
 * switch off is listed here, too.
 */
const disabledFeatures = [
  'WebUIOmniboxPopup',
  'WebUIOmniboxAimPopup',
  'WebUIOmniboxFullPopup',
  'AimEnabled',
  'AvoidCorsURLLoaderRestartOnRedirect',
  'AvoidUnnecessaryBeforeUnloadCheckSync',
  'DestroyProfileOnBrowserClose',
  'HttpsFirstBalancedModeAutoEnable',
  'HttpsUpgrades',
  'LensOverlay',
  'MediaRouter',
  'NetworkTimeServiceQuerying',
  'OptimizationHints',
  'PaintHolding',
  'PreconnectToSearch',
  'TcpPortRandomizationWin',
  'ThirdPartyStoragePartitioning',
];

/** What Playwright's `firefox.launch` takes for Debian's Firefox, which it drives by WebDriver BiDi. */
export const FIREFOX = { channel: 'moz-firefox', executablePath: '/usr/bin/firefox-esr' };

/** What Playwright's `chromium.launch` takes; without a browser, Playwright itself says so. */
export function launchOptions() {
  const executablePath = findBrowser();
  const args = [...browserArgs, `--disable-features=${disabledFeatures.join(',')}`];
  return { ...(executablePath && { executablePath }), args };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  try {
    if (!findBrowser()) installBrowser();
    const path = findBrowser();
    if (!path) throw new Error('The installed browser is not where it was expected.');
    console.log(`Browser: ${path}`);
  } catch (error) {
    console.error(`No browser for the tests: ${error instanceof Error ? error.message : error}`);
    console.error('Install Chrome or Chromium, or set CHROME_PATH to the program, and start again.');
    process.exit(1);
  }
}
