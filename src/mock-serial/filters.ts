import type { PortFilter, PortInfo, PortRequestOptions } from './types.js';
import { defined, dictionary, given, sequence, unsigned } from './web-idl.js';

/** The end of every service class of the Bluetooth standard itself. */
const BLUETOOTH_BASE_UUID = '-0000-1000-8000-00805f9b34fb';
const SERIAL_PORT_PROFILE = `00001101${BLUETOOTH_BASE_UUID}`;
const UUID = /^[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}$/;

/** @throws TypeError when it is neither a number of 32 bits nor a UUID in lower case. */
function serviceClassUuid(id: number | string): string {
  const uuid = typeof id === 'number' ? id.toString(16).padStart(8, '0') + BLUETOOTH_BASE_UUID : id;
  if (UUID.test(uuid)) return uuid;
  throw new TypeError(`${id} is not a Bluetooth service class.`);
}

/**
 * The information as `getInfo()` gives it: without undefined members, the service class as a UUID.
 * @throws TypeError when the service class or a USB number is not valid.
 */
export function normalizeInfo(info: PortInfo): PortInfo {
  const { usbVendorId, usbProductId, bluetoothServiceClassId } = info;
  for (const id of [usbVendorId, usbProductId]) {
    if (id !== undefined && !(Number.isInteger(id) && id >= 0 && id <= 0xffff))
      throw new TypeError('A USB number must be a whole number from 0 to 65535.');
  }
  // Web IDL gives the members in the order of their names.
  return defined({
    bluetoothServiceClassId: given(bluetoothServiceClassId, serviceClassUuid),
    usbProductId,
    usbVendorId,
  });
}

/** The checks of a filter in the steps of `requestPort()`. @throws TypeError */
function checkFilter(filter: PortFilter): PortFilter {
  const { usbVendorId, usbProductId, bluetoothServiceClassId } = filter;
  if (bluetoothServiceClassId !== undefined) {
    if (usbVendorId !== undefined || usbProductId !== undefined) {
      throw new TypeError('A filter has either a Bluetooth service class or USB numbers.');
    }
  } else if (usbVendorId === undefined) {
    throw new TypeError(
      usbProductId === undefined ? 'A filter must not be empty.' : 'A filter with a product needs its vendor.',
    );
  }
  return normalizeInfo(filter);
}

/** The standard's "matches the filter". */
function matches(info: PortInfo, filter: PortFilter): boolean {
  if (filter.bluetoothServiceClassId !== undefined) {
    return info.bluetoothServiceClassId === filter.bluetoothServiceClassId;
  }
  if (info.usbVendorId !== filter.usbVendorId) return false;
  return filter.usbProductId === undefined || info.usbProductId === filter.usbProductId;
}

/**
 * What Web IDL does to the argument of `requestPort()`: the type decides between a text and a number.
 * @throws TypeError
 */
export function convertRequestOptions(options: PortRequestOptions): PortRequestOptions {
  const serviceClass = (id: unknown): number | string =>
    typeof id === 'number' || typeof id === 'bigint' ? unsigned(id, 32) : `${id}`;
  const usbNumber = (id: unknown): number => unsigned(id, 16);
  const of = dictionary(options);
  return {
    allowedBluetoothServiceClassIds: given(of.allowedBluetoothServiceClassIds, (ids) =>
      sequence(ids, 'allowedBluetoothServiceClassIds').map(serviceClass),
    ),
    filters: given(of.filters, (filters) =>
      sequence(filters, 'filters').map((filter) => {
        const members = dictionary(filter);
        return {
          bluetoothServiceClassId: given(members.bluetoothServiceClassId, serviceClass),
          usbProductId: given(members.usbProductId, usbNumber),
          usbVendorId: given(members.usbVendorId, usbNumber),
        };
      }),
    ),
  };
}

/**
 * Which ports a chooser offers for a request.
 * @throws TypeError when a filter is empty, names a product without its vendor, or USB numbers together with a service
 * class, or when a service class is not valid.
 */
export function offered(options: PortRequestOptions): (info: PortInfo) => boolean {
  const filters = (options.filters ?? []).map(checkFilter);
  const allowed = (options.allowedBluetoothServiceClassIds ?? []).map(serviceClassUuid);
  return (info) => {
    const service = info.bluetoothServiceClassId;
    // The standard's blocklist names only service classes of the Bluetooth standard itself.
    if (typeof service === 'string' && service !== SERIAL_PORT_PROFILE) {
      if (service.endsWith(BLUETOOTH_BASE_UUID) || !allowed.includes(service)) return false;
    }
    return filters.length === 0 || filters.some((filter) => matches(info, filter));
  };
}
