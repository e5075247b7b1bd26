import { Player } from '../timeline/preview/player.js';
import { TimelineModel } from '../timeline/view-model.js';

/**
 * How the pilot looks at the program on the screen. Outlasts the view, so a pilot who comes back finds it as it was.
 */
export class ProgramPicture {
  readonly timeline = new TimelineModel();
  /** It shows the time about which the pilot asks on the timeline. */
  readonly player = new Player(this.timeline.asked);
}
