import { attempt } from './services.js';

/** A file of the built page: its address relative to the page, and the checksum of its bytes (`sha256-...`). */
export interface SiteFile {
  readonly url: string;
  readonly integrity: string;
  /** Not every pilot needs it: it is kept from its first use on. */
  readonly later?: true;
}

/** Nothing is drawn without these. */
const NEEDED = /\.(?:js|css)$/;
/** How long the browser may take to find a kept file, in milliseconds. After that the file comes from the host. */
const KEPT_WAIT = 3000;

/**
 * The files of one version of the page, kept for use without a network. It keeps only files that the build has made: a
 * host that answers with anything else changes nothing.
 */
export class SiteCache {
  readonly #files: ReadonlyMap<string, SiteFile>;
  readonly #scope: string;
  readonly #name: string;

  /** @param scope the address of the page, with a slash at its end. */
  constructor(files: readonly SiteFile[], scope: string) {
    this.#scope = scope;
    this.#files = new Map(files.map((file) => [new URL(file.url, scope).href, file]));
    // Each version has a cache of its own. The cache before it stays whole until this version has taken over.
    this.#name = `sidus-timer ${hash(files.map(({ integrity }) => integrity).join(' '))} ${scope}`;
  }

  /**
   * The address under which a file of this version is kept; null for any other request. The page has one address,
   * whatever follows its question mark.
   */
  addressOf(request: Pick<Request, 'url' | 'method'>): string | null {
    if (request.method !== 'GET') return null;
    const { origin, pathname } = new URL(request.url);
    const address = `${origin}${pathname}`;
    const file = address === this.#scope ? `${address}index.html` : address;
    return this.#files.has(file) ? file : null;
  }

  /**
   * Fetches all files that every pilot needs, and the optional ones that the version before had.
   * @throws when one of them has the wrong bytes: then this version is not installed.
   */
  async fill(): Promise<void> {
    const cache = await caches.open(this.#name);
    const files = [...this.#files].map(async ([address, { later }]) => {
      if (!later || (await caches.match(address))) await this.#fetch(cache, address);
    });
    await Promise.all(files);
  }

  /** Deletes the caches of all other versions. */
  async dropOthers(): Promise<void> {
    const names = await caches.keys();
    const others = names.filter((name) => name !== this.#name && name.endsWith(this.#scope));
    await Promise.all(others.map((name) => caches.delete(name)));
  }

  /** Answers a request for a file of this version. A missing file is fetched again, if there is a network. */
  async answer(address: string, request: Request): Promise<Response> {
    let cache: Cache;
    let kept: Response | undefined;
    let whole: boolean;
    try {
      cache = await attempt(() => caches.open(this.#name), KEPT_WAIT);
      const opened = cache;
      kept = await attempt(() => opened.match(address), KEPT_WAIT);
      whole = request.mode !== 'navigate' || (await this.#mend(cache));
    } catch {
      // The cache does not open: works as if there were no worker.
      return await fetch(request);
    }
    if (kept && whole) return kept;
    try {
      if (whole) return await this.#fetch(cache, address);
      // The page is of no use without its scripts. When one is gone and cannot be fetched, the host's page is better.
      const fetched = await fetch(request);
      return fetched.ok || !kept ? fetched : kept;
    } catch {
      return kept ?? (await fetch(request));
    }
  }

  /** @returns whether everything that the page needs to draw is there now. */
  async #mend(cache: Cache): Promise<boolean> {
    const kept = new Set((await attempt(() => cache.keys(), KEPT_WAIT)).map(({ url }) => url));
    const missing = [...this.#files.keys()].filter((address) => NEEDED.test(address) && !kept.has(address));
    const mended = await Promise.allSettled(missing.map((address) => this.#fetch(cache, address)));
    return mended.every(({ status }) => status === 'fulfilled');
  }

  async #fetch(cache: Cache, address: string): Promise<Response> {
    const integrity = this.#files.get(address)?.integrity ?? '';
    const get = (from: RequestCache): Promise<Response> =>
      fetch(address, { integrity, cache: from, credentials: 'same-origin' });
    // A cache on the way may be stale or damaged: tries once more at the host itself.
    const fetched = await get('no-cache').catch(() => get('reload'));
    if (!fetched.ok) throw new Error(`${fetched.status} for ${address}`);
    // A browser refuses to open a page from a redirected response, so this makes a new one.
    const { headers, status, statusText } = fetched;
    const response = fetched.redirected ? new Response(fetched.body, { headers, status, statusText }) : fetched;
    await cache.put(address, response.clone());
    return response;
  }
}

/** A short name for a long text. Two versions do not share one by chance. */
function hash(text: string): string {
  let [a, b] = [0x811c9dc5, 0x9dc5811c];
  for (let i = 0; i < text.length; i++) {
    const code = text.charCodeAt(i);
    a = Math.imul(a ^ code, 0x01000193);
    b = Math.imul(b ^ code, 0x85ebca6b) ^ a;
  }
  return [a, b].map((part) => (part >>> 0).toString(16).padStart(8, '0')).join('');
}
