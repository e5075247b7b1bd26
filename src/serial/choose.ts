import { ConnectionError } from './errors.js';
import type { SerialLike, SerialPortLike } from './types.js';

/** What a browser says of itself before anything is tried. */
export interface Surroundings {
  readonly serial?: SerialLike | undefined;
  readonly isSecureContext: boolean;
}

/**
 * Whether serial ports can be used here at all.
 * @returns null when they can, else why not.
 */
export function availability({ serial, isSecureContext }: Surroundings): 'insecure' | 'unsupported' | null {
  if (serial) return null;
  return isSecureContext ? 'unsupported' : 'insecure';
}

/** The ports that the pilot has allowed before and that are plugged in now. Needs no click. */
export async function rememberedPorts(serial: SerialLike): Promise<SerialPortLike[]> {
  try {
    return (await serial.getPorts()).filter(({ connected }) => connected !== false);
  } catch (error) {
    throw refused(error);
  }
}

/**
 * Lets the pilot choose a port in the browser's own dialog. Must be called from a click. Asks without filters: a list of USB
 * vendors would hide Bluetooth ports and adapters that nobody has heard of.
 * @throws ConnectionError `nothing-chosen` or `not-allowed`.
 */
export async function choosePort(serial: SerialLike): Promise<SerialPortLike> {
  try {
    return await serial.requestPort();
  } catch (error) {
    throw refused(error);
  }
}

function refused(error: unknown): ConnectionError {
  if (error instanceof DOMException && error.name === 'NotFoundError') {
    return new ConnectionError('nothing-chosen', 'no port was chosen', error);
  }
  return new ConnectionError('not-allowed', 'the browser does not allow serial ports here', error);
}
