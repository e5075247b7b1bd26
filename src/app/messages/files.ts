import { signal } from '@preact/signals';
import { files } from './en-files.js';

/** Every language must have these sentences about the files of the library. */
export type FilesMessages = typeof files;

/** The sentences about files in the current language. They are loaded with the parts that show them. */
export const filesMessages = signal<FilesMessages>(files);
