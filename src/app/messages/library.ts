import { signal } from '@preact/signals';
import { library } from './en-library.js';

/** What every language must give of the library. */
export type LibraryMessages = typeof library;

/** The sentences of the library in the language in force: they are fetched with the parts that show them. */
export const libraryMessages = signal<LibraryMessages>(library);
