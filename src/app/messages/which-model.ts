import { signal } from '@preact/signals';
import { whichModel } from './en-which-model.js';

/** The sentences about the model in the current language. They are loaded with the parts that show them. */
export const modelMessages = signal<typeof whichModel>(whichModel);
