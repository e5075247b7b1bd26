import type { OpenedOptions, OpenOptions } from './types.js';

/** As Chromium's; the standard leaves the bound to the browser. */
const MAX_BUFFER_SIZE = 16 * 1024 * 1024;

const PARITIES: readonly string[] = ['none', 'even', 'odd'] satisfies OpenedOptions['parity'][];
const FLOW_CONTROLS: readonly string[] = ['none', 'hardware'] satisfies OpenedOptions['flowControl'][];

/** Web IDL's [EnforceRange]: an integer from 0 to `max`. */
function integer(value: unknown, max: number, name: string): number {
  const number = Math.trunc(Number(value));
  // Also false for NaN.
  if (number >= 0 && number <= max) return number;
  throw new TypeError(`${name} must be a number from 0 to ${max}.`);
}

/** Web IDL's enumeration. */
function oneOf(value: unknown, values: readonly string[], name: string): string {
  if (values.includes(String(value))) return String(value);
  throw new TypeError(`${name} must be one of ${values.join(', ')}.`);
}

/**
 * What Web IDL does to the argument of `open()` before the method's steps begin.
 * @throws TypeError when the baud rate is missing, a number is out of its type's range or a word is not of its
 * enumeration.
 */
export function convertOpenOptions(options: OpenOptions): OpenedOptions {
  if (options?.baudRate === undefined) throw new TypeError('baudRate is required.');
  const { baudRate, dataBits = 8, stopBits = 1, parity = 'none', bufferSize = 255, flowControl = 'none' } = options;
  return Object.freeze({
    baudRate: integer(baudRate, 0xffffffff, 'baudRate'),
    dataBits: integer(dataBits, 0xff, 'dataBits'),
    stopBits: integer(stopBits, 0xff, 'stopBits'),
    parity: oneOf(parity, PARITIES, 'parity'),
    bufferSize: integer(bufferSize, 0xffffffff, 'bufferSize'),
    flowControl: oneOf(flowControl, FLOW_CONTROLS, 'flowControl'),
  }) as OpenedOptions;
}

/** The checks among the steps of `open()`. @throws TypeError */
export function checkOpenOptions({ baudRate, dataBits, stopBits, bufferSize }: OpenedOptions): void {
  if (baudRate === 0) throw new TypeError('baudRate must be greater than 0.');
  if (dataBits !== 7 && dataBits !== 8) throw new TypeError('dataBits must be 7 or 8.');
  if (stopBits !== 1 && stopBits !== 2) throw new TypeError('stopBits must be 1 or 2.');
  if (bufferSize === 0) throw new TypeError('bufferSize must be greater than 0.');
  if (bufferSize > MAX_BUFFER_SIZE) throw new TypeError(`bufferSize must not exceed ${MAX_BUFFER_SIZE}.`);
}
