import type { Lack } from '../state/keeping.js';
import type { StorageErrorCode } from '../storage/index.js';

/** While the browser does not keep, or give back, what it should. */
export const keeping = {
  title: 'This browser does not keep everything.',
  storage: {
    slow: 'Its storage does not answer. Until it does, what you type, backups and the note of an interrupted write are kept only while this page is open.',
    blocked:
      'Another tab holds an older version of this page. Close it and load this page again. Until then, what you type, backups and the note of an interrupted write are kept only while this page is open.',
    full: 'Its storage is full. What you type, new backups and the note of an interrupted write are kept only while this page is open.',
    newer:
      'A newer version of this page has written what is kept here. Load the page again to use it. Until then, what you type, backups and the note of an interrupted write are kept only while this page is open.',
    missing:
      'It has no storage for this page, or it is switched off. What you type, backups and the note of an interrupted write are kept only while this page is open.',
    failed:
      'Its storage fails. What you type, backups and the note of an interrupted write are kept only while this page is open.',
  } satisfies Record<StorageErrorCode, string>,
  lacks: {
    locks: 'Tabs of this page cannot be told apart. Use one tab only.',
    channel: 'Other tabs of this page are not noticed. Close them before you connect.',
    settings: 'Colours, presets and other choices last only while this page is open.',
    offline: 'The page itself is not kept: without a network it cannot be opened.',
  } satisfies Record<Lack, string>,
};

/** Inside of another page. */
export const framed = {
  title: 'Sidus Timer works only in a tab of its own.',
  why: 'It lies inside another page here, which could cover what you see of your timer.',
  open: 'Open Sidus Timer in a tab of its own',
};
