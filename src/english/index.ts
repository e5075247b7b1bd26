/**
 * What a program for pilots says in English: names of slots and values, findings of the check, errors.
 * @module english
 */

export { errorText } from './errors.js';
export { fieldName, findingText, slotName } from './program.js';
