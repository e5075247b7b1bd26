export { availability, choosePort, rememberedPorts, type Surroundings } from './choose.js';
export { type ConnectOptions, connect, type TimerConnection } from './connection.js';
export { ConnectionError, type ConnectionErrorCode } from './errors.js';
export type { SerialLike, SerialPortLike } from './types.js';
