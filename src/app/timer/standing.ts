import { computed, type ReadonlySignal } from '@preact/signals';
import { type Change, differences, type Model, sameLayout, type TimerProgram } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import type { ModelRecord } from '../storage/index.js';
import type { Knowledge } from './knowledge.js';
import { type Known, lastRead } from './known.js';
import type { Link } from './link.js';
import type { NextFlight } from './next-flight.js';

/**
 * How certain it is that the timer still holds what was read of the memory on the screen.
 * Times are milliseconds since 1970.
 */
export type Standing =
  /** It was read on this connection, and nothing was sent since. */
  | { readonly sure: 'now'; readonly at: number; readonly verified: boolean }
  /**
   * It was read earlier: the timer may hold something else by now. `at` is null when the time was not kept. `sent`: how
   * many values the timer has acknowledged since, which nobody has read back; absent for none.
   */
  | { readonly sure: 'once'; readonly at: number | null; readonly sent?: number }
  /** A write into it was interrupted. */
  | { readonly sure: 'not'; readonly at: number | null };

/** What is known of a memory, and how sure that is. */
export interface Held {
  readonly known: Known;
  readonly sure: Standing['sure'];
}

/** What a memory of a model's timer holds, as far as it is known. */
export interface HeldNow {
  readonly program: TimerProgram;
  /** When it was seen, in milliseconds since 1970. */
  readonly at: number;
  /** Whether it was read on the present connection, and nothing was sent since. */
  readonly now: boolean;
}

interface StandingParts {
  readonly knowledge: Pick<Knowledge, 'of' | 'isSent'>;
  readonly editor: Pick<Editor, 'working' | 'baseline' | 'fresh' | 'changes'>;
  readonly link: Pick<Link, 'connection' | 'simulated'>;
  readonly nextFlight: Pick<NextFlight, 'memory' | 'open'>;
  /** The model of the connected timer; null when it is not known. */
  readonly model: ReadonlySignal<Model | null>;
}

/**
 * What may be said of the content of timers. Marks, figures and sentences about what a timer holds come from here, on
 * the screen and on paper.
 */
export class Standings {
  /** About the program on the screen, which need not be of the memory that flies next. */
  readonly screen: ReadonlySignal<Standing>;
  /** About the memory that flies next, whatever is on the screen; null while it is not known which one that is. */
  readonly next: ReadonlySignal<Held | null>;
  /** How it differs from what was last read of its memory: by what was typed, and by what was sent since. */
  readonly sinceRead: ReadonlySignal<readonly Change[]>;
  readonly #parts: StandingParts;
  /** The memory of the program on the screen: not the program, which changes with each digit. */
  readonly #memory: ReadonlySignal<number | null>;

  constructor(parts: StandingParts) {
    this.#parts = parts;
    const { editor, nextFlight } = parts;
    this.#memory = computed(() => editor.working.value?.memory ?? null);
    const held = computed(() => this.of(this.#memory.value));
    this.next = computed(() => (nextFlight.open.value ? null : this.of(nextFlight.memory.value)));
    this.screen = computed(() => {
      const { known, sure } = held.value;
      if (known.state === 'uncertain') return { sure: 'not', at: known.readAt };
      if (known.state === 'unread') return { sure: 'once', at: null };
      const { at, verified, program } = known;
      if (sure === 'now') return { sure, at, verified };
      const sent = changesFrom(program, editor.baseline.value).length;
      return sent > 0 ? { sure: 'once', at, sent } : { sure: 'once', at };
    });
    this.sinceRead = computed(() => {
      const { known } = held.value;
      // Without a reading of this page the editor has the one that was kept.
      const read = known.state === 'read' ? known.program : null;
      return read && editor.baseline.value ? changesFrom(read, editor.working.value) : editor.changes.value;
    });
  }

  /**
   * About a memory of the timer at hand.
   * @param memory counted from 0; null when the timer does not say which is current.
   */
  of(memory: number | null): Held {
    const { knowledge, editor, link } = this.#parts;
    const known = knowledge.of(memory);
    if (known.state === 'uncertain') return { known, sure: 'not' };
    const isOnScreen = this.#memory.value === memory;
    const isFresh = !knowledge.isSent(memory) && (editor.fresh.value || !isOnScreen);
    return { known, sure: known.state === 'read' && link.connection.value && isFresh ? 'now' : 'once' };
  }

  /**
   * What a memory of a model's timer holds now, if that timer is connected; else what it last held.
   * @param memory counted from 0; null for a timer that does not say which memory is current.
   * @returns null when neither is known.
   */
  heldBy({ key, verified }: ModelRecord, memory: number | null, simulated: boolean): HeldNow | null {
    const { link, model } = this.#parts;
    const isHere = link.connection.value && model.value?.id === key && link.simulated.value === simulated;
    const { known, sure } = isHere ? this.of(memory) : { known: null, sure: 'once' };
    if (known?.state === 'read') return { program: known.program, at: known.at, now: sure === 'now' };
    // After an interrupted write nobody knows.
    if (known?.state === 'uncertain') return null;
    const last = verified.find((held) => held.program.memory === memory && (held.simulated ?? false) === simulated);
    return last ? { program: last.program, at: last.at, now: false } : null;
  }

  /** The memories of the timer that were read, with what they last held. */
  readMemories(): readonly (Held & { readonly memory: number; readonly program: TimerProgram })[] {
    const count = this.#parts.editor.baseline.value?.identity.memories ?? 0;
    return Array.from({ length: count }, (_, memory) => memory).flatMap((memory) => {
      const held = this.of(memory);
      const program = lastRead(held.known);
      return program ? [{ ...held, memory, program }] : [];
    });
  }
}

function changesFrom(read: TimerProgram, now: TimerProgram | null): readonly Change[] {
  return now && sameLayout(read.identity, now.identity) ? differences(read, now) : [];
}
