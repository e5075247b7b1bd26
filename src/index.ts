/**
 * Everything that your own program needs to talk to a timer: protocol, program and client.
 * @module
 */

export * from './client/public.js';
export * from './program/public.js';
export * from './protocol/public.js';
