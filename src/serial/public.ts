/**
 * From `navigator.serial` to a client: choose a port, find the rate, wait for the timer, come back after a loss.
 * @module serial
 */

export { availability, type Surroundings } from './choose.js';
export { ConnectionError, type ConnectionErrorCode } from './errors.js';
export { type RememberedPort, TimerLink, type TimerLinkOptions } from './link.js';
export type { LinkState, TimerConnection } from './link-state.js';
export { LINK_TABLE, type LinkStatus } from './link-table.js';
export type { KnownPort, PortKind } from './ports.js';
export type { Heard } from './rate-listener.js';
export { DEFAULT_SETTINGS, type OpenedSettings, type SerialSettings } from './settings.js';
export type { PortInfo, SerialLike, SerialPortLike } from './types.js';
