import { signal } from '@preact/signals';
import { library } from './en-library.js';

/** Every language must have these sentences about the library. */
export type LibraryMessages = typeof library;

/** The sentences of the library in the current language. They are loaded with the parts that show them. */
export const libraryMessages = signal<LibraryMessages>(library);
