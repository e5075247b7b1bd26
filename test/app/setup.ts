import { cleanup, configure } from '@testing-library/preact';
import { afterEach } from 'vitest';

// What is waited for comes at once, but on a busy machine that may take its time.
configure({ asyncUtilTimeout: 10_000 });
afterEach(cleanup);

// happy-dom lays nothing out: nothing is at any point.
document.elementsFromPoint ??= () => [];
