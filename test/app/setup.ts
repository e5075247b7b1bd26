import { act, cleanup, configure } from '@testing-library/preact';
import { afterAll, afterEach, vi } from 'vitest';
import { speak } from '../../src/app/messages/language.js';
import { fetchParts } from '../../src/app/parts.js';

// The page answers at once, but a busy machine may take long.
configure({ asyncUtilTimeout: 10_000 });
// The next test must find what a test has changed of the browser as if it was the first.
afterEach(async () => {
  // In one act, so that every effect has ended.
  await act(cleanup);
  vi.useRealTimers();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
  localStorage.clear();
});
// Like a page that the pilot has had open for a moment.
await fetchParts();
await speak('en');

// And the next file what happy-dom has.
afterAll(() => {
  const { documentElement: root, head, body } = document;
  for (const element of [root, head, body]) {
    for (const name of element.getAttributeNames()) element.removeAttribute(name);
  }
  head.replaceChildren();
  body.replaceChildren();
  location.hash = '';
});

// happy-dom has no layout, so no element is at any point.
document.elementsFromPoint ??= () => [];
