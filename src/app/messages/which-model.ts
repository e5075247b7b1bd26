import { signal } from '@preact/signals';
import { whichModel } from './en-which-model.js';

/** The sentences about the model in the language in force: they are fetched with the parts that show them. */
export const modelMessages = signal<typeof whichModel>(whichModel);
