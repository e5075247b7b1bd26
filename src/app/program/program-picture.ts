import { signal } from '@preact/signals';
import type { ProgramField } from '../../program/index.js';
import { Player } from '../timeline/preview/player.js';
import { TimelineModel } from '../timeline/view-model.js';

/**
 * How the pilot looks at the program on the screen. Outlasts the view, so a pilot who comes back finds it as it was.
 */
export class ProgramPicture {
  readonly timeline = new TimelineModel();
  /** It shows the time about which the pilot asks on the timeline. */
  readonly player = new Player(this.timeline.asked);
  // Only this class writes them.
  /** Whether it stands in place of the table, on a phone. */
  readonly isOpen = signal(false);
  /** The field to which the pilot goes from elsewhere. The table gives it the focus. */
  readonly sought = signal<ProgramField | null>(null);

  toggle(): void {
    this.isOpen.value = !this.isOpen.value;
  }

  seek(field: ProgramField): void {
    this.isOpen.value = false;
    this.sought.value = field;
  }

  /** The sought field has the focus. */
  found(): void {
    this.sought.value = null;
  }
}
