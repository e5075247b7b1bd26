import { signal } from '@preact/signals';
import { files } from './en-files.js';

/** What every language must give of the files of the library. */
export type FilesMessages = typeof files;

/** The sentences about files in the language in force: they are fetched with the parts that show them. */
export const filesMessages = signal<FilesMessages>(files);
