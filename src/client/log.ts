import type { Frame, RejectionReason } from '../protocol/index.js';

/** One thing seen on the line: a frame that was sent, a frame that came, or bytes that belong to no frame. */
export interface LineEntry {
  /** Milliseconds since 1970, by the client's clock. */
  readonly time: number;
  readonly direction: 'out' | 'in';
  /** The bytes as they went or came. */
  readonly bytes: Uint8Array;
  /** Null for bytes that belong to no frame. */
  readonly frame: Frame | null;
  /** Why bytes belong to no frame; null for a frame. */
  readonly rejected: RejectionReason | null;
}
