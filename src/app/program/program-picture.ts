import { type ReadonlySignal, signal } from '@preact/signals';
import { Player } from '../timeline/preview/player.js';
import { TimelineModel } from '../timeline/view-model.js';

/** What the picture compares with: what the timer holds, nothing, or a backup by its key. */
export const HELD = 'held';
export const NOTHING = 'nothing';

/**
 * How the pilot looks at the program on the screen. Outlasts the view, so a pilot who comes back finds it as it was.
 */
export class ProgramPicture {
  readonly timeline = new TimelineModel();
  readonly player = new Player();
  readonly #behind = signal(HELD);
  readonly behind: ReadonlySignal<string> = this.#behind;

  /** @param key {@link HELD}, {@link NOTHING}, or that of a backup. */
  compareWith(key: string): void {
    this.#behind.value = key;
  }
}
