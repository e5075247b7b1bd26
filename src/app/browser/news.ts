import type { News, Release } from './update-news.js';
import { version } from './version.js';

declare global {
  interface ImportMetaEnv {
    /** What is new, from CHANGELOG.md; the build fills it in. */
    readonly VITE_NEWS?: readonly Release[];
  }
}

/** What is new in this version. It is long, so the page fetches it only when asked. The worker has it, too. */
export const news: News = { version, releases: import.meta.env.VITE_NEWS ?? [] };
