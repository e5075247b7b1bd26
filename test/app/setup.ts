import { cleanup, configure } from '@testing-library/preact';
import { afterAll, afterEach, vi } from 'vitest';
import { fetchParts } from '../../src/app/parts.js';

// What is waited for comes at once, but on a busy machine that may take its time.
configure({ asyncUtilTimeout: 10_000 });
afterEach(cleanup);
// As a pilot finds the page who has looked at it for a moment.
await fetchParts();

// The next file finds all as if it was the first.
afterAll(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
  localStorage.clear();
  sessionStorage.clear();
  const { documentElement: root, head, body } = document;
  for (const element of [root, head, body]) {
    for (const name of element.getAttributeNames()) element.removeAttribute(name);
  }
  head.replaceChildren();
  body.replaceChildren();
  location.hash = '';
});

// happy-dom lays nothing out: nothing is at any point.
document.elementsFromPoint ??= () => [];
