import { readFileSync } from 'node:fs';
import type {
  CodecErrorCode,
  CodecOptions,
  CommandName,
  Identity,
  LayoutQuirks,
  Reply,
  Request,
} from '../../src/protocol/index.js';

/** How a row differs from the usual reading. */
interface RowQuirks extends LayoutQuirks {
  readonly bareChecksum?: boolean;
}

interface Conditions {
  readonly identity?: Identity;
  readonly quirks?: RowQuirks;
}

export interface Row<Message> extends Conditions {
  readonly name: string;
  readonly hex: string;
  readonly message: Message;
}

interface Refusal extends Conditions {
  readonly name: string;
  readonly direction: 'request' | 'reply';
  readonly code: CodecErrorCode;
  readonly field: string;
}

/** One step of a stream: bytes come, or the line falls silent; then these frames are delivered. */
interface Step {
  readonly push?: string;
  readonly idle?: true;
  /** Command and data of each, in hex. */
  readonly frames: readonly string[];
}

/** test/vectors.json, which is published with the package. */
export interface Table {
  readonly description: Readonly<Record<string, string>>;
  readonly version: 1;
  readonly requests: readonly Row<Request>[];
  readonly replies: readonly Row<Reply>[];
  readonly badHex: readonly (Refusal & { readonly hex: string; readonly pending?: CommandName })[];
  readonly badValues: readonly (Refusal & { readonly message: Request & Reply })[];
  readonly streams: readonly {
    readonly name: string;
    readonly quirks?: { readonly bareChecksum?: boolean };
    readonly steps: readonly Step[];
  }[];
}

export const table = JSON.parse(readFileSync(new URL('../vectors.json', import.meta.url), 'utf8')) as Table;

/** The conditions of a row, as options of the codec. */
export function optionsOf({ identity, quirks }: Conditions): CodecOptions {
  return { identity, ...(quirks && { quirks, bareChecksum: quirks.bareChecksum ?? false }) };
}
