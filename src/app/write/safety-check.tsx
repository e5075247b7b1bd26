import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';

/** Said once for each connection, before anything is written or moved. */
export function SafetyCheck({ session }: { readonly session: Session }) {
  return (
    <label class="check safety">
      <input
        type="checkbox"
        checked={session.safe.value}
        onChange={(event) => session.setSafe(event.currentTarget.checked)}
      />
      {messages.value.write.safety}
    </label>
  );
}
