import { computed, effect, type ReadonlySignal } from '@preact/signals';
import * as v from 'valibot';
import type { TimerProgram } from '../../program/index.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import type { Editor } from '../editing/editor.js';
import { time } from '../records/preferences.js';
import { programKey } from '../timer/record-keys.js';
import type { Standings } from '../timer/standing.js';
import type { OnScreen } from './on-screen.js';
import type { Origin } from './origin.js';
import type { Reader } from './reader.js';

/** A short DT in the connected timer. Times are hundredths of a second. */
export interface ShortDtWord {
  /** Counted from 0; null when the timer does not say which memory is current. */
  readonly memory: number | null;
  readonly dt: number;
  /** The long DT to go on with. */
  readonly back: number;
  /** Whether this memory held it before; otherwise it is what a round of the class needs. */
  readonly remembered: boolean;
}

/** The DT that a contest round needs, if nothing else is known: 3 min, or 5 min for F1E. */
const USUAL = 18_000;
const USUAL_E = 30_000;

/** How many are remembered: five memories of twenty models. */
const MOST = 100;
const remembered = v.record(v.pipe(v.string(), v.maxLength(200)), time);

interface ShortDtParts {
  readonly editor: Pick<Editor, 'shortDt'>;
  readonly onScreen: Pick<OnScreen, 'simulated'>;
  readonly origin: Pick<Origin, 'timer'>;
  readonly standings: Pick<Standings, 'next'>;
  readonly reader: Pick<Reader, 'byteOrderOpen'>;
}

/**
 * A short DT brings a model down early, as for trimming. Forgotten, it costs a flight. So the last long DT of each
 * memory is remembered and can be put back. The pilot sets the limit between them, see `Preferences`.
 */
export class ShortDt {
  /** Null unless a fresh reading shows that the memory which flies next has a short DT. */
  readonly held: ReadonlySignal<ShortDtWord | null>;
  readonly #parts: ShortDtParts;

  constructor(parts: ShortDtParts) {
    this.#parts = parts;
    const { standings, reader } = parts;
    /** What flies next, by a reading of this connection: not an older reading, and not another memory. */
    const now = computed(() => {
      const { known, sure } = standings.next.value ?? {};
      return sure === 'now' && known?.state === 'read' && !reader.byteOrderOpen.value ? known.program : null;
    });
    this.held = computed(() => {
      const program = now.value;
      if (!program || !this.isShort(program)) return null;
      return { memory: program.memory, dt: dtOf(program), ...this.#back(program) };
    });
    effect(() => {
      const program = now.value;
      if (program && !this.isShort(program)) this.#remember(this.#keys(program), dtOf(program));
    });
  }

  /** Whether the DT of a program is short. */
  isShort(program: TimerProgram): boolean {
    return dtOf(program) < this.#parts.editor.shortDt.value;
  }

  /** The last long DT of this memory: of this model, or else of this kind of timer; else what the class needs. */
  #back(program: TimerProgram): Pick<ShortDtWord, 'back' | 'remembered'> {
    const kept = loadSetting('long-dts', remembered) ?? {};
    const limit = this.#parts.editor.shortDt.value;
    const usual = program.identity.timerClass === 'E' ? USUAL_E : USUAL;
    const known = this.#keys(program).map((key) => kept[key]);
    const last = known.find((dt) => dt !== undefined && dt >= limit);
    return { back: last ?? Math.max(usual, limit), remembered: last !== undefined };
  }

  /** The keys under which its DT is remembered, the most certain first. */
  #keys(program: TimerProgram): readonly string[] {
    const model = this.#parts.origin.timer.value;
    const byKind = programKey(program, this.#parts.onScreen.simulated.value);
    return model === null ? [byKind] : [`model/${model.id}/${program.memory ?? '?'}`, byKind];
  }

  #remember(keys: readonly string[], dt: number): void {
    // Read each time: another tab may have stored something in the meantime.
    const before = loadSetting('long-dts', remembered) ?? {};
    if (keys.every((key) => before[key] === dt)) return;
    const others = Object.entries(before).filter(([key]) => !keys.includes(key));
    const latest = keys.map((key): [string, number] => [key, dt]);
    saveSetting('long-dts', Object.fromEntries([...others, ...latest].slice(-MOST)));
  }
}

function dtOf({ identity, times }: TimerProgram): number {
  return times[identity.functions] as number;
}
