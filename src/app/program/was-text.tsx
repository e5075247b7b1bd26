import { messages } from '../messages/index.js';
import { useModels } from '../models.js';

/** What a changed value was, in the words of what is known of it: what the timer holds, or what was last read. */
export function WasText({ value }: { readonly value: string }) {
  const { session } = useModels();
  const { marks, notCertain } = messages.value.knowledge;
  const { sure } = session.standing.value;
  return (
    <>
      {marks[sure](value)}
      {sure === 'not' && <span class="visually-hidden">{notCertain}</span>}
    </>
  );
}
