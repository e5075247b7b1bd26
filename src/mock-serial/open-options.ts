import type { OpenedOptions, OpenOptions } from './types.js';
import { dictionary, given, integer, oneOf } from './web-idl.js';

/** The limit of Chromium; the standard leaves it to the browser. */
const MAX_BUFFER_SIZE = 16 * 1024 * 1024;

const PARITIES: readonly string[] = ['none', 'even', 'odd'] satisfies OpenedOptions['parity'][];
const FLOW_CONTROLS: readonly string[] = ['none', 'hardware'] satisfies OpenedOptions['flowControl'][];

/**
 * What Web IDL does to the argument of `open()` before the method's steps begin.
 * @throws TypeError when the baud rate is missing, a number is out of its type's range or a word is not in its
 * enumeration.
 */
export function convertOpenOptions(options: OpenOptions): OpenedOptions {
  const of = dictionary(options);
  const { baudRate } = of;
  if (baudRate === undefined) throw new TypeError('baudRate is required.');
  return Object.freeze({
    baudRate: integer(baudRate, 0xffffffff, 'baudRate'),
    bufferSize: given(of.bufferSize, (value) => integer(value, 0xffffffff, 'bufferSize')) ?? 255,
    dataBits: given(of.dataBits, (value) => integer(value, 0xff, 'dataBits')) ?? 8,
    flowControl: given(of.flowControl, (value) => oneOf(value, FLOW_CONTROLS, 'flowControl')) ?? 'none',
    parity: given(of.parity, (value) => oneOf(value, PARITIES, 'parity')) ?? 'none',
    stopBits: given(of.stopBits, (value) => integer(value, 0xff, 'stopBits')) ?? 1,
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
