import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { TimerError } from '../../client/index.js';
import {
  COMMANDS,
  type Command,
  type CommandName,
  commandOf,
  encodeFrame,
  type Frame,
  type LayoutOptions,
  MAX_DATA,
} from '../../protocol/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { Session } from '../session/session.js';

/** Why a typed text is no byte, or no data. */
export type FrameFault = 'not-hex' | 'odd-digits' | 'not-a-byte' | 'too-long';

/** `edit`: being edited. `confirm`: the pilot has to confirm it. `sending`: on its way. */
export type FrameStep = 'edit' | 'confirm' | 'sending';

/** The result of the last frame: its reply, or null when none came. */
export interface FrameResult {
  readonly reply: Frame | null;
}

/** A frame that the pilot sends by hand. A frame that may do more than read needs a confirmation, and goes out once. */
export class FrameForm {
  readonly #command = signal<CommandName | null>('GETSWVER', { name: 'command' });
  readonly #letter = signal('', { name: 'letter' });
  readonly #data = signal('', { name: 'data' });
  /** The connection on which the first click came. Another connection may be another timer. */
  readonly #asking = signal<TimerConnection | null>(null, { name: 'asking' });
  readonly #result = signal<FrameResult | null>(null, { name: 'result' });
  /** A command; null for any other letter. */
  readonly command: ReadonlySignal<CommandName | null> = this.#command;
  readonly letter: ReadonlySignal<string> = this.#letter;
  readonly data: ReadonlySignal<string> = this.#data;
  readonly step: ReadonlySignal<FrameStep> = computed(() => {
    if (this.#session.runner.job.value?.kind === 'frame') return 'sending';
    const asking = this.#asking.value;
    return asking && asking === this.#session.connection.value ? 'confirm' : 'edit';
  });
  readonly result: ReadonlySignal<FrameResult | null> = this.#result;
  readonly letterFault: ReadonlySignal<FrameFault | null> = computed(() =>
    this.command.value || /^(0x)?[0-9a-f]{2}$/i.test(this.letter.value.trim()) ? null : 'not-a-byte',
  );
  readonly dataFault: ReadonlySignal<FrameFault | null> = computed(() => {
    const parsed = parseHex(this.data.value);
    return typeof parsed === 'string' ? parsed : null;
  });
  /** The frame in the form; null while something in it is wrong. */
  readonly frame: ReadonlySignal<Frame | null> = computed(() => {
    const data = parseHex(this.data.value);
    if (this.letterFault.value || typeof data === 'string') return null;
    const { value: name } = this.command;
    return { code: name ? COMMANDS[name].request : Number.parseInt(this.letter.value, 16), data };
  });
  /** Its bytes on the wire. */
  readonly bytes: ReadonlySignal<Uint8Array | null> = computed(
    () => this.frame.value && encodeFrame(this.frame.value.code, this.frame.value.data),
  );
  /** What it may do to the timer. */
  readonly effect: ReadonlySignal<Command['effect']> = computed(() =>
    this.frame.value ? effectOf(this.frame.value) : 'unknown',
  );
  /** Whether there is a frame, and the wire is free for it. */
  readonly ready: ReadonlySignal<boolean> = computed(
    () => this.frame.value !== null && this.#session.runner.ready.value,
  );
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
  }

  /** What is known about the timer and decides how frames are read. */
  get layout(): LayoutOptions {
    const client = this.#session.connection.value?.client;
    return client ? { identity: client.identity ?? undefined, quirks: client.quirksAssumed } : {};
  }

  /** Takes over what was chosen or typed. A confirmation that was asked for ends. */
  edit(change: { readonly command?: CommandName | null; readonly letter?: string; readonly data?: string }): void {
    if (this.step.value === 'sending') return;
    batch(() => {
      if (change.command !== undefined) this.#command.value = change.command;
      if (change.letter !== undefined) this.#letter.value = change.letter;
      if (change.data !== undefined) this.#data.value = change.data;
      this.#asking.value = null;
      this.#result.value = null;
    });
  }

  /** Sends a frame that only reads. Asks for a confirmation of any other. */
  async send(): Promise<void> {
    if (!this.ready.value || this.step.value !== 'edit') return;
    if (this.effect.value === 'reads') return await this.#send();
    batch(() => {
      this.#asking.value = this.#session.connection.value;
      this.#result.value = null;
    });
  }

  /** Sends the confirmed frame once. */
  async confirm(): Promise<void> {
    if (this.ready.value && this.step.value === 'confirm') await this.#send();
  }

  /** The pilot does not confirm. */
  cancel(): void {
    this.#asking.value = null;
  }

  async #send(): Promise<void> {
    const frame = this.frame.value;
    if (!frame) return;
    const effect = this.effect.value;
    const mayStore = effect === 'stores' || effect === 'unknown';
    const maySelect = effect === 'unknown' || frame.code === COMMANDS.SETMEMORY.request;
    const { runner, editor, nextFlight, servoMoves, connection } = this.#session;
    const before = connection.value;
    await runner.run('frame', async ({ client }, options) => {
      batch(() => {
        this.#asking.value = null;
        this.#result.value = null;
        if (mayStore) editor.sent();
        // Until the reading below has told the current memory, nobody knows which one flies next.
        if (maySelect) nextFlight.leave(null);
      });
      const answer = client.send(frame.code, frame.data, options);
      if (effect !== 'reads') servoMoves.mayMove();
      try {
        this.#result.value = { reply: await answer };
      } catch (error) {
        const isLost = error instanceof TimerError && error.code === 'port-lost';
        if (isLost && effect !== 'reads') this.#result.value = { reply: null };
        throw error;
      }
    });
    // The screen may be out of date, even when no reply came.
    if (mayStore && connection.value === before) await this.#session.reader.read();
  }
}

/** What a frame may do. A request that only reads must look exactly as the table says. */
function effectOf({ code, data }: Frame): Command['effect'] {
  const command = commandOf(code);
  if (command?.direction !== 'request') return 'unknown';
  const { effect } = COMMANDS[command.name];
  return effect === 'reads' && data.length > 0 ? 'unknown' : effect;
}

/** Bytes in hex, two digits each, with or without spaces between them. */
function parseHex(text: string): Uint8Array | FrameFault {
  const words = text
    .split(/[\s,]+/)
    .filter(Boolean)
    .map((word) => word.replace(/^0x/i, ''));
  if (words.some((word) => !/^[0-9a-f]+$/i.test(word))) return 'not-hex';
  if (words.some((word) => word.length % 2 !== 0)) return 'odd-digits';
  const digits = words.join('').match(/../g) ?? [];
  return digits.length > MAX_DATA ? 'too-long' : Uint8Array.from(digits, (byte) => Number.parseInt(byte, 16));
}
