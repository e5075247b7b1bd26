import { act, cleanup, configure } from '@testing-library/preact';
import { afterAll, afterEach, vi } from 'vitest';
import { speak } from '../../src/app/messages/language.js';
import { fetchParts } from '../../src/app/parts.js';

// The page answers at once, but a busy machine may take long.
configure({ asyncUtilTimeout: 10_000 });
// In one act, so that every effect has ended before the next test begins.
afterEach(() => act(cleanup));
// Like a page that the pilot has had open for a moment.
await fetchParts();
await speak('en');

// The next file must find everything as if it was the first.
afterAll(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
  localStorage.clear();
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
