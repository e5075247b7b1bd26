import { signal } from '@preact/signals';
import { comparing } from './en-compare.js';

/** The sentences of comparisons in the language in force: they are fetched with the parts that show them. */
export const comparingMessages = signal<typeof comparing>(comparing);
