import { CodecError, type Identity, slotCount } from '../protocol/index.js';
import { BytesError, base64url, crc32, fromBase64url, PackedReader, PackedWriter } from './bytes.js';
import { LIMITS, requireSetting, type Setting } from './library.js';
import { text } from './require.js';

/** What a link carries: a setting, without the fields that only the sender's library can use. */
export interface SharedSetting extends Pick<Setting, 'name' | 'note' | 'tags' | 'at' | 'program'> {
  /** The name of the model, up to 60 characters. Empty when it belongs to none. */
  readonly modelName: string;
}

/** Stands before the code in the fragment of an address: `https://…/#s=AVE…`. */
export const LINK_MARK = '#s=';

const VERSION = 1;
/** Bytes of the checksum at the end. */
const SUM = 4;
/**
 * No setting needs more characters: the longest note, all tags and the largest program, all in the widest characters.
 */
const LONGEST_CODE = 60_000;
/** The bits of the byte that says which optional parts are there. */
const HAS_MEMORY = 1;
const HAS_THROTTLE = 2;
/** Ends a note that was cut. */
const CUT = ' …';

/**
 * Packs a whole setting into the characters of base64url, `A-Z a-z 0-9 - _`: version, timer, values, texts and a
 * checksum. docs/file-format.md shows the bytes. A setting of 44 values with 60 characters of text takes under 200.
 * An address that opens it in the page is that of the page, {@link LINK_MARK} and this code.
 * @param options.longest the most characters that the code may have. A longer note is cut at its end, because a QR
 * code has little room. Nothing else is ever cut, so a code without a note may still be longer.
 * @throws CodecError as {@link formatLibraryFile} when it is no setting.
 */
export function encodeLink(shared: SharedSetting, options: { readonly longest?: number } = {}): string {
  const setting = requireShared(shared);
  const { longest = Number.POSITIVE_INFINITY } = options;
  const whole = pack(setting);
  if (whole.length <= longest) return whole;
  // The longest beginning that fits, found by halving. No character is cut in two.
  const characters = [...setting.note];
  const cutTo = (count: number): string => {
    const note = count === 0 ? '' : characters.slice(0, count).join('').trimEnd() + CUT;
    return pack({ ...setting, note });
  };
  let fits = 0;
  let tooLong = characters.length;
  while (tooLong - fits > 1) {
    const middle = Math.floor((fits + tooLong) / 2);
    if (cutTo(middle).length <= longest) fits = middle;
    else tooLong = middle;
  }
  return cutTo(fits);
}

/**
 * Reads a setting from a code, a fragment or a whole address with `#s=`. White space inside, which mail programs add,
 * does no harm; nor do other words or signs after it, nor signs of the link in percent coding.
 * @throws CodecError `bad-link`: no setting, or a cut or damaged one; `newer-version`; `too-large`. A whole code whose
 * values no setting can hold gives an error as {@link formatLibraryFile}.
 */
export function decodeLink(link: string): SharedSetting {
  const text = link.replaceAll(/%[0-7][\da-f]/gi, decodeURIComponent);
  const mark = text.lastIndexOf(LINK_MARK);
  const given = mark < 0 ? text : text.slice(mark + LINK_MARK.length);
  if (given.length > LONGEST_CODE) {
    const details = { value: given.length, max: LONGEST_CODE };
    throw new CodecError('too-large', 'link', `a link has at most ${LONGEST_CODE} characters`, details);
  }
  try {
    return requireShared(unpackWords(given.trim().replace(/[^\w\s-].*/s, '')));
  } catch (cause) {
    if (cause instanceof BytesError) throw new CodecError('bad-link', 'link', `no whole link: ${cause.message}`);
    throw cause;
  }
}

/** In place of the number of a firmware that is none. Its text follows. */
const NO_NUMBER = 0xffff;
const NUMBER = /^\d{3}$/;

function firmwareFrom(from: PackedReader): string {
  const number = from.pair();
  if (number !== NO_NUMBER) return String(number).padStart(3, '0');
  const text = from.text();
  if (NUMBER.test(text)) throw new BytesError('a number stands as a text');
  return text;
}

function pack({ name, note, tags, at, program, modelName }: SharedSetting): string {
  const { identity, memory, times, positions, idleThrottle } = program;
  const to = new PackedWriter();
  to.byte(VERSION);
  to.byte(identity.timerClass.charCodeAt(0));
  const isNumber = NUMBER.test(identity.firmware);
  to.pair(isNumber ? Number(identity.firmware) : NO_NUMBER);
  if (!isNumber) to.text(identity.firmware);
  to.byte(identity.functions);
  to.byte(identity.memories);
  to.byte(identity.servos);
  to.byte((memory === null ? 0 : HAS_MEMORY) + (idleThrottle === null ? 0 : HAS_THROTTLE));
  if (memory !== null) to.byte(memory);
  if (idleThrottle !== null) to.byte(idleThrottle);
  for (const time of times) to.pair(time);
  for (const position of positions.flat()) to.byte(position);
  to.number(at);
  for (const each of [name, modelName, note]) to.text(each);
  to.byte(tags.length);
  for (const tag of tags) to.text(tag);
  const sum = crc32(to.bytes);
  to.pair(sum & 0xffff);
  to.pair(sum >>> 16);
  return base64url(to.bytes);
}

/** A code that was broken into lines; or one line, and the words that somebody has put after it. */
function unpackWords(text: string): unknown {
  const words = text.split(/\s/);
  try {
    return unpack(fromBase64url(words.join('')));
  } catch (cause) {
    if (!(cause instanceof BytesError)) throw cause;
    return unpack(fromBase64url(words[0] as string));
  }
}

/**
 * In every version the first byte is the version and the last four are the checksum.
 * So a newer code is told from a damaged one.
 */
function unpack(bytes: Uint8Array): unknown {
  const from = new PackedReader(bytes.subarray(0, -SUM));
  const end = new PackedReader(bytes.subarray(-SUM));
  if (end.pair() + 0x1_0000 * end.pair() !== crc32(bytes.subarray(0, -SUM))) {
    throw new BytesError('the checksum does not fit');
  }
  const version = from.byte();
  if (version > VERSION) {
    throw new CodecError('newer-version', 'link', `version ${version} is newer than ${VERSION}`, {
      value: version,
      max: VERSION,
    });
  }
  if (version !== VERSION) throw new BytesError(`there is no version ${version}`);
  const identity: Identity = {
    timerClass: String.fromCharCode(from.byte()),
    firmware: firmwareFrom(from),
    functions: from.byte(),
    memories: from.byte(),
    servos: from.byte(),
  };
  const has = from.byte();
  if (has > HAS_MEMORY + HAS_THROTTLE) throw new BytesError('it says that it holds what there is not');
  const memory = has & HAS_MEMORY ? from.byte() : null;
  const idleThrottle = has & HAS_THROTTLE ? from.byte() : null;
  const slots = slotCount(identity);
  const times = Array.from({ length: slots }, () => from.pair());
  const positions = Array.from({ length: identity.servos }, () => [...from.take(slots)]);
  const at = from.number();
  const [name, modelName, note] = [from.text(), from.text(), from.text()];
  const tags = Array.from({ length: from.byte() }, () => from.text());
  if (from.left > 0) throw new BytesError('something follows its end');
  return { name, modelName, note, tags, at, program: { identity, memory, times, positions, idleThrottle } };
}

/** As strict as for stored settings: a link may come from anybody. */
function requireShared(value: unknown): SharedSetting {
  const shared = value as SharedSetting;
  const { name, note, tags, at, program } = requireSetting({
    ...shared,
    id: 'link',
    model: null,
    from: 'link',
    archived: false,
  });
  return { name, note, tags, at, program, modelName: text(shared.modelName, 'setting.modelName', LIMITS.name) };
}
