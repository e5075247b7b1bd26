import { execFileSync } from 'node:child_process';
import { accessSync, constants } from 'node:fs';
import { join } from 'node:path';
import { env, platform } from 'node:process';

/** Debian's packages of each program that the rig starts. */
const PACKAGES: Readonly<Record<string, string>> = {
  Xvfb: 'xvfb',
  xdotool: 'xdotool',
  python3: 'python3',
  unshare: 'util-linux',
  nsenter: 'util-linux',
  mount: 'mount',
};

/**
 * What `unshare` is told to make the namespaces of a box. The user namespace is for root too: only to those without
 * rights outside does an open port refuse itself.
 */
export const NAMESPACES = ['--user', '--map-root-user', '--mount', '--net'];

/** The same of what it starts for one browser only. */
const OF_BROWSER: Readonly<Record<'chromium' | 'firefox', Readonly<Record<string, string>>>> = {
  chromium: { chromium: 'chromium' },
  firefox: { 'firefox-esr': 'firefox-esr', cc: 'gcc libc6-dev' },
};

/** The first Firefox with Web Serial. */
const FIREFOX = 151;

/**
 * Looks for all that the rig needs and installs nothing.
 * @throws Error one sentence that says what is missing, and what brings it.
 */
export function requireNeeds(browser: 'chromium' | 'firefox'): void {
  if (platform !== 'linux') throw new Error(`The rig runs on Linux only, and this is ${platform}.`);
  const packages = { ...OF_BROWSER[browser], ...PACKAGES };
  const missing = Object.keys(packages).filter((program) => !isInPath(program));
  if (missing.length > 0) {
    const names = [...new Set(missing.map((program) => packages[program]))].join(' ');
    const command = `apt-get install --no-install-recommends ${names}`;
    throw new Error(`This machine lacks what the rig needs: ${missing.join(', ')}. On Debian: ${command}`);
  }
  if (browser === 'firefox') {
    const version = execFileSync('firefox-esr', ['--version'], { encoding: 'utf8' }).trim();
    if (Number(/\d+/.exec(version)) < FIREFOX) {
      throw new Error(`Web Serial came with Firefox ${FIREFOX}, and firefox-esr is ${version}. Update Debian.`);
    }
  }
  if (!canMount()) {
    throw new Error(
      'The rig needs its own namespaces, and this machine refuses them. Allow them (sysctl user.max_user_namespaces, ' +
        'kernel.apparmor_restrict_unprivileged_userns), or start the container with --privileged.',
    );
  }
}

function isInPath(program: string): boolean {
  const { PATH = '' } = env;
  return PATH.split(':').some((folder) => {
    try {
      accessSync(join(folder, program), constants.X_OK);
      return true;
    } catch {
      return false;
    }
  });
}

function canMount(): boolean {
  try {
    execFileSync('unshare', [...NAMESPACES, 'mount', '--bind', '/sys/class/tty', '/sys/class/tty'], {
      stdio: 'ignore',
    });
    return true;
  } catch {
    return false;
  }
}
