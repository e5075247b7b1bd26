import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { TimerError } from '../../client/index.js';
import { encodeFrame, type Frame, type LayoutOptions, MAX_DATA } from '../../protocol/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { Session } from '../work/session.js';

/** Why a typed text is no frame. */
export type FrameFault = 'hex' | 'too-long';

/** The result of the last frame: its reply, or null when none came. */
export interface FrameResult {
  readonly reply: Frame | null;
}

type FormParts = Pick<
  Session,
  'connection' | 'editor' | 'knowledge' | 'nextFlight' | 'reader' | 'runner' | 'safety' | 'servoMoves'
>;

/**
 * A frame that the pilot sends by hand. Nobody knows for certain what one does, so each needs a confirmation, goes out
 * once, and the timer is read after it.
 */
export class FrameForm {
  /** The connection on which the pilot was asked. Another connection may be another timer. */
  readonly #asking = signal<TimerConnection | null>(null);
  // Only this model writes these.
  /** Letter and data in hex, as typed. */
  readonly typed = signal('');
  readonly result = signal<FrameResult | null>(null);
  readonly fault: ReadonlySignal<FrameFault | null> = computed(() => {
    const parsed = parseHex(this.typed.value);
    return typeof parsed === 'string' ? parsed : null;
  });
  /** The frame in the form; null while there is none. */
  readonly frame: ReadonlySignal<Frame | null> = computed(() => {
    const parsed = parseHex(this.typed.value);
    if (typeof parsed === 'string') return null;
    const [code, ...data] = parsed;
    return code === undefined ? null : { code, data: Uint8Array.from(data) };
  });
  /** Its bytes on the wire. */
  readonly bytes: ReadonlySignal<Uint8Array | null> = computed(
    () => this.frame.value && encodeFrame(this.frame.value.code, this.frame.value.data),
  );
  readonly asking: ReadonlySignal<boolean> = computed(
    () => this.#asking.value !== null && this.#asking.value === this.#parts.connection.value,
  );
  readonly sending: ReadonlySignal<boolean> = computed(() => this.#parts.runner.job.value?.kind === 'frame');
  /** Whether there is a frame, and the wire is free for it. */
  readonly ready: ReadonlySignal<boolean> = computed(() => this.frame.value !== null && this.#parts.runner.ready.value);
  readonly #parts: FormParts;

  constructor(parts: FormParts) {
    this.#parts = parts;
  }

  /** What is known about the timer and decides how frames are read. */
  get layout(): LayoutOptions {
    const client = this.#parts.connection.value?.client;
    return client ? { identity: client.identity ?? undefined, quirks: client.quirksAssumed } : {};
  }

  /** Takes over what was typed. A confirmation that was asked for ends. */
  type(text: string): void {
    if (this.sending.value) return;
    batch(() => {
      this.typed.value = text;
      this.#asking.value = null;
      this.result.value = null;
    });
  }

  /** Asks for a confirmation. */
  ask(): void {
    if (!this.ready.value) return;
    batch(() => {
      this.#asking.value = this.#parts.connection.value;
      this.result.value = null;
    });
  }

  /** The pilot does not confirm. */
  cancel(): void {
    this.#asking.value = null;
  }

  /** Sends the confirmed frame once, then reads the timer, even when no reply came. */
  async confirm(): Promise<void> {
    const frame = this.frame.value;
    const { runner, editor, knowledge, nextFlight, servoMoves, connection, safety, reader } = this.#parts;
    if (!frame || !this.ready.value || !this.asking.value || !safety.confirmed.value) return;
    const before = connection.value;
    await runner.run('frame', async ({ client }, options) => {
      batch(() => {
        this.#asking.value = null;
        this.result.value = null;
        editor.sent();
        knowledge.sent();
        // Until the reading below has told the current memory, nobody knows which one flies next.
        nextFlight.leave(null);
      });
      const answer = client.send(frame.code, frame.data, options);
      servoMoves.mayMove();
      try {
        this.result.value = { reply: await answer };
      } catch (error) {
        if (error instanceof TimerError && error.code === 'port-lost') this.result.value = { reply: null };
        throw error;
      }
    });
    if (connection.value === before) await reader.read();
  }
}

/** Bytes in hex, two digits each, with or without spaces between them. */
function parseHex(text: string): readonly number[] | FrameFault {
  const words = text
    .split(/[\s,]+/)
    .filter(Boolean)
    .map((word) => word.replace(/^0x/i, ''));
  if (!words.every((word) => /^([0-9a-f]{2})+$/i.test(word))) return 'hex';
  const digits = words.join('').match(/../g) ?? [];
  return digits.length > 1 + MAX_DATA ? 'too-long' : digits.map((byte) => Number.parseInt(byte, 16));
}
