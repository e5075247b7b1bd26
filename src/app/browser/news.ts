import type { News, Release } from './update-news.js';
import { version } from './version.js';

declare global {
  interface ImportMetaEnv {
    /** What is new, from CHANGELOG.md; put in by the build. */
    readonly VITE_NEWS?: readonly Release[];
  }
}

/** What is new in this version. It is long: the page fetches it when it is asked for, and the worker has it. */
export const news: News = { version, releases: import.meta.env.VITE_NEWS ?? [] };
