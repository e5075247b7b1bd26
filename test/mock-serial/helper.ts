import { VirtualClock } from '../../src/line/index.js';
import { MockSerial, type MockSerialPort, type OpenOptions, type PlugOptions } from '../../src/mock-serial/index.js';

/** A port that is plugged in, granted and open. */
export async function openPort(options: Partial<OpenOptions> = {}, plug: PlugOptions = {}) {
  const serial = new MockSerial();
  const port = serial.plug({ usbVendorId: 1, usbProductId: 2 }, { granted: true, ...plug });
  await port.open({ baudRate: 9600, ...options });
  return { serial, port, device: port.device };
}

/** An open port on a clock that is turned by hand. */
export async function timed(options: PlugOptions = {}, baudRate = 9600, bufferSize = 255) {
  const clock = new VirtualClock();
  return { clock, ...(await openPort({ baudRate, bufferSize }, { clock, timing: true, ...options })) };
}

/** The name of the error with which a promise rejects. */
export async function failure(promise: Promise<unknown>): Promise<string> {
  try {
    await promise;
  } catch (error) {
    return error instanceof Error ? error.name : String(error);
  }
  return 'none';
}

export function reading(port: MockSerialPort): ReadableStreamDefaultReader<Uint8Array> {
  if (!port.readable) throw new Error('The port is not readable.');
  return port.readable.getReader();
}

export function writing(port: MockSerialPort): WritableStreamDefaultWriter<Uint8Array> {
  if (!port.writable) throw new Error('The port is not writable.');
  return port.writable.getWriter();
}

/** So many bytes, the first 256 counting from 0. No two stretches are alike. */
export function counted(length: number): Uint8Array {
  return Uint8Array.from({ length }, (_, index) => index + 31 * (index >> 8));
}

/** Reads at least `length` bytes, in as many reads as that takes. */
export async function collect(read: () => Promise<Uint8Array | undefined>, length: number): Promise<number[]> {
  const bytes: number[] = [];
  while (bytes.length < length) {
    const piece = await read();
    if (!piece || piece.length === 0) break;
    bytes.push(...piece);
  }
  return bytes;
}

/** Lets everything happen that waits for neither a clock nor another party. */
export function settled(): Promise<void> {
  return new Promise((resolve) => setImmediate(resolve));
}

/** Whether a promise has settled once everything else has happened. */
export async function isPending(promise: Promise<unknown>): Promise<boolean> {
  let pending = true;
  const settle = (): void => {
    pending = false;
  };
  promise.then(settle, settle);
  await settled();
  return pending;
}
