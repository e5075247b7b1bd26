/**
 * What a program of one's own needs to talk to a timer: protocol, program and client.
 * @module
 */

export * from './client/index.js';
export * from './program/index.js';
export * from './protocol/index.js';
