import { messages } from '../messages/index.js';
import { memoryName } from '../messages/names.js';
import { Choice } from '../ui/choice.js';
import { SegmentChoice } from '../ui/segment-choice.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import type { WriteJob } from './write-job.js';

/** With more memories, a list of one line takes the place of the row of buttons. */
const MOST_BUTTONS = 8;

interface WriteToProps {
  readonly session: Session;
  readonly write: WriteJob;
  /** The memory whose difference is shown, counted from 0; null where the timer does not say which that is. */
  readonly chosen: number | null;
}

/** Into which memory the program on the screen is to be written. The one that flies next goes on being that. */
export function WriteTo({ session, write, chosen }: WriteToProps) {
  const { write: words } = messages.value;
  const { editor, nextFlight } = session;
  const { identity } = editor.baseline.value ?? {};
  // Without it nobody knows which one to come back to.
  const isKnown = nextFlight.memory.value !== null;
  if (!identity || !isKnown || chosen === null || identity.memories < 2) return null;
  const all = Array.from({ length: identity.memories }, (_, each) => each);
  if (all.length > MOST_BUTTONS) {
    const nameOf = (each: number): string => memoryText(session, each);
    return (
      <Choice
        label={words.target}
        choices={all}
        chosen={chosen}
        nameOf={nameOf}
        onChoose={(each) => write.writeTo(each)}
      />
    );
  }
  return (
    <SegmentChoice
      name="write-to"
      title={words.target}
      choices={all.map(String)}
      names={Object.fromEntries(all.map((each) => [each, memoryName(each)]))}
      chosen={String(chosen)}
      onChoose={(each) => write.writeTo(Number(each))}
      isSlow
    />
  );
}
