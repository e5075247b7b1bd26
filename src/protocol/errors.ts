/**
 * What can be wrong with a value that is to become bytes, or with bytes that are to become a value.
 * - `not-an-integer`: a value is not a whole number.
 * - `out-of-range`: a value is smaller or larger than its field can carry on this timer.
 * - `wrong-count`: a list does not have one entry for each slot, or for each servo.
 * - `wrong-length`: the data of a frame is shorter or longer than its command needs, or than a frame can hold.
 * - `unknown-command`: no command has this letter.
 * - `unexpected-reply`: the frame does not answer the pending request.
 * - `bad-identity`: no timer can have sent this version reply; the error carries its bytes.
 * - `identity-needed`: only the timer's identity gives the layout of these bytes, and it is missing.
 * - `bad-capture`: a text is no capture, or a list holds no entries of one; the field names the line or the entry.
 * - `wrong-type`: a value is of another type than its field: a text, a list, an object.
 * - `unknown-word`: a field accepts only certain words, and this is none of them.
 * - `bad-file`: a text is no library file, or a damaged one.
 * - `bad-link`: a text carries no setting, or it was cut or damaged on its way.
 * - `newer-version`: a newer version of this program made the file or link; the value is its version number.
 * - `too-large`: a text is longer, or nested deeper, than anything that a pilot keeps.
 * - `duplicate`: a name or an id that must be unique stands twice.
 */
export type CodecErrorCode =
  | 'not-an-integer'
  | 'out-of-range'
  | 'wrong-count'
  | 'wrong-length'
  | 'unknown-command'
  | 'unexpected-reply'
  | 'bad-identity'
  | 'identity-needed'
  | 'bad-capture'
  | 'wrong-type'
  | 'unknown-word'
  | 'bad-file'
  | 'bad-link'
  | 'newer-version'
  | 'too-large'
  | 'duplicate';

/** Facts about a {@link CodecError}, for the sentence that the pilot reads. */
export interface CodecErrorDetails {
  /** The value that was refused. */
  readonly value?: unknown;
  /** Smallest value or length allowed. */
  readonly min?: number;
  /** Largest value or length allowed. */
  readonly max?: number;
  /** What was expected in its place, in a few English words: `a list`, `1 to 60 characters`. */
  readonly wanted?: string;
  /** The bytes that could not be read. */
  readonly bytes?: Uint8Array;
  /** The line in a text, counted from 1. */
  readonly line?: number;
  /** The column in that line, counted from 1. */
  readonly column?: number;
}

/** The one error of the rooms that turn values into bytes and back. Its message is for developers. */
export class CodecError extends Error {
  override readonly name = 'CodecError';
  /** What is wrong. */
  readonly code: CodecErrorCode;
  /** Which value is wrong: `position`, `times[3]`, `identity.functions`, `data` ... */
  readonly field: string;
  /** Facts about it. */
  readonly details: CodecErrorDetails;

  /** @param message for developers; the page has its own sentence for each code. */
  constructor(code: CodecErrorCode, field: string, message: string, details: CodecErrorDetails = {}) {
    super(message);
    this.code = code;
    this.field = field;
    this.details = details;
  }

  /** What `structuredClone()`, `postMessage()` and `JSON` can carry. Of the error itself they keep no code. */
  toJSON(): Pick<CodecError, 'name' | 'code' | 'field' | 'message' | 'details'> {
    return { ...this, message: this.message };
  }
}

/** @throws CodecError `not-an-integer` or `out-of-range` unless `value` is a whole number from `min` to `max`. */
export function requireInteger(value: unknown, field: string, min: number, max: number): asserts value is number {
  if (!Number.isInteger(value)) {
    throw new CodecError(
      'not-an-integer',
      field,
      `${field} must be a whole number, not ${typeof value === 'number' ? value : typeof value}`,
      { value },
    );
  }
  if ((value as number) < min || (value as number) > max) {
    throw new CodecError('out-of-range', field, `${field} must be ${min} to ${max}, not ${value}`, {
      value,
      min,
      max,
    });
  }
}
