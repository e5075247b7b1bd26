import { modelMessages } from '../messages/which-model.js';
import type { Crossing } from '../session/crossing.js';
import { NoticeText } from '../ui/notice-text.js';

interface CrossingCheckProps {
  readonly crossing: Crossing | null;
  readonly acknowledged: boolean;
  readonly onAcknowledge: (read: boolean) => void;
}

/** Values of one model are about to go into the timer of another: asked by both names. */
export function CrossingCheck({ crossing, acknowledged, onAcknowledge }: CrossingCheckProps) {
  const { crossing: words } = modelMessages.value;
  if (!crossing) return null;
  const to = crossing.to.map(({ name }) => name);
  return (
    <div class="notice bad" role="alert">
      <NoticeText said={{ title: words.title(crossing.from.name, to), advice: words.advice }} />
      <label class="check">
        <input
          type="checkbox"
          checked={acknowledged}
          onChange={(event) => onAcknowledge(event.currentTarget.checked)}
        />
        {words.confirm(crossing.from.name, to)}
      </label>
    </div>
  );
}
