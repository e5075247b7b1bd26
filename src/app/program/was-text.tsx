import type { ReadonlySignal } from '@preact/signals';
import { messages } from '../messages/index.js';
import type { Standing } from '../session/standing.js';

interface WasTextProps {
  readonly standing: ReadonlySignal<Standing>;
  readonly value: string;
}

/** What a changed value was, in the words of what is known of it: what the timer holds, or what was last read. */
export function WasText({ standing, value }: WasTextProps) {
  const { marks, notCertain } = messages.value.knowledge;
  const { sure } = standing.value;
  return (
    <>
      {marks[sure](value)}
      {sure === 'not' && <span class="visually-hidden">{notCertain}</span>}
    </>
  );
}
