import type { TimerErrorCode } from '../../client/index.js';
import type { ConnectionErrorCode, PortInfo } from '../../serial/index.js';

/** What there is to say beside errors. */
export type NoteCode =
  | 'edits-restored'
  | 'edits-kept'
  | 'edits-moved'
  | 'edits-set-aside'
  | 'back-same'
  | 'back-changed'
  | 'other-kind'
  | 'write-completed'
  | 'nothing-written'
  | 'select-unanswered'
  | 'strays'
  | 'taken-over'
  | 'not-kept'
  | 'unexpected';

/** Something to say to the pilot, by code: the sentence stands in messages/. */
export type Notice =
  | {
      readonly kind: 'connection';
      readonly code: ConnectionErrorCode;
      readonly port: PortInfo | null;
      /** See `portKey`; null when no port is meant. */
      readonly portKey: string | null;
      /** What came in the place of an answer, where that tells something. */
      readonly bytes: Uint8Array | null;
    }
  | { readonly kind: 'timer'; readonly code: TimerErrorCode }
  | { readonly kind: 'note'; readonly code: NoteCode };
