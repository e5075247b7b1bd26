import { modelMessages } from '../messages/en-which-model.js';
import type { Crossing } from '../records/crossing.js';
import { Check } from '../ui/check.js';
import { NoticeText } from '../ui/notice-text.js';
import type { WriteJob } from './write-job.js';

interface CrossingCheckProps {
  readonly crossing: Crossing | null;
  readonly write: WriteJob;
}

/** Asks whether to write values of one model into the timer of another, and names both. */
export function CrossingCheck({ crossing, write }: CrossingCheckProps) {
  const { crossing: words } = modelMessages;
  if (!crossing) return null;
  const to = crossing.to.map(({ name }) => name);
  return (
    <div class="notice bad" role="alert">
      <NoticeText said={{ title: words.title(crossing.from.name, to), advice: words.advice }} />
      <Check checked={write.crossed.value} onChange={(checked) => write.cross(checked)}>
        {words.confirm(crossing.from.name, to)}
      </Check>
    </div>
  );
}
