import { signal } from '@preact/signals';
import { comparing } from './en-compare.js';

/** The sentences of comparisons in the current language. They are loaded with the parts that show them. */
export const comparingMessages = signal<typeof comparing>(comparing);
