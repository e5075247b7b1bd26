import { messages } from '../messages/index.js';
import { Icon } from '../ui/icon.js';
import { useHandedFocus } from '../ui/use-handed-focus.js';
import type { TimelineModel } from './view-model.js';

const ZOOM = 2;

interface ToolsProps {
  readonly model: TimelineModel;
  /** The place of the scale around which to zoom: that of the selected mark, or of the time in question. */
  readonly anchor: () => number | undefined;
}

/** Buttons for how much of the flight is in view. While all of it is, there is only the one that zooms in. */
export function Tools({ model, anchor }: ToolsProps) {
  const { timeline } = messages.value;
  // The other two go with the last step back.
  const box = useHandedFocus('button');
  return (
    // biome-ignore lint/a11y/useSemanticElements: buttons that belong together are no form
    <div {...box} class="row" role="group" aria-label={timeline.tools}>
      {model.zoomed && (
        <button type="button" class="chip" aria-label={timeline.zoomOut} onClick={() => model.zoom(1 / ZOOM, anchor())}>
          <Icon path="M4 10H16" />
        </button>
      )}
      <button type="button" class="chip" aria-label={timeline.zoomIn} onClick={() => model.zoom(ZOOM, anchor())}>
        <Icon path="M4 10H16M10 4V16" />
      </button>
      {model.zoomed && (
        <button type="button" class="chip" aria-label={timeline.fit} onClick={() => model.fit()}>
          <Icon path="M2 4V16M18 4V16M5 10H15M8 7L5 10L8 13M12 7L15 10L12 13" />
        </button>
      )}
    </div>
  );
}
