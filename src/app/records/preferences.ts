import { type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { MAX_TIME } from '../../protocol/index.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import type { Editor } from '../editing/editor.js';

/** DT from a trimming flight to a fly-off, in hundredths of a second. */
const USUAL_PRESETS = [2000, 6000, 18000, 24000, 30000, 36000, 48000, 60000];
const MOST_PRESETS = 24;

/** A time that a timer can hold, in hundredths of a second. */
export const time = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(MAX_TIME));
const times = v.pipe(v.array(time), v.maxLength(MOST_PRESETS));

/**
 * What a pilot sets once for all timers: the presets of DT, and below which time a DT is short.
 * In hundredths of a second.
 */
export class Preferences {
  readonly #presets = signal<readonly number[]>(loadSetting('dt-presets', times) ?? USUAL_PRESETS);
  /** In rising order. */
  readonly presets: ReadonlySignal<readonly number[]> = this.#presets;
  /** A DT below this counts as short. */
  readonly shortDt: ReadonlySignal<number>;
  readonly #editor: Editor;

  constructor(editor: Editor) {
    this.#editor = editor;
    this.shortDt = editor.shortDt;
    const shortDt = loadSetting('short-dt', time);
    if (shortDt !== null) editor.callShort(shortDt);
  }

  /** @returns false when they are too many, or no timer could hold one. */
  setPresets(values: readonly number[]): boolean {
    const presets = [...new Set(values)].sort((a, b) => a - b);
    if (!v.is(times, presets)) return false;
    this.#presets.value = presets;
    saveSetting('dt-presets', presets);
    return true;
  }

  /** @returns false when no timer could hold the value. */
  setShortDt(value: number): boolean {
    if (!v.is(time, value)) return false;
    this.#editor.callShort(value);
    saveSetting('short-dt', value);
    return true;
  }
}
