/**
 * Everything that your own program needs to talk to a timer: protocol, program and client.
 * @module
 */

export * from './client/index.js';
export * from './program/index.js';
export * from './protocol/index.js';
