import { messages } from '../messages/index.js';
import { useModels } from '../models.js';

/** Said once for each connection, before anything is written or moved. */
export function SafetyCheck() {
  const { session } = useModels();
  return (
    <label class="check safety">
      <input
        type="checkbox"
        checked={session.safe.value}
        onChange={(event) => (session.safe.value = event.currentTarget.checked)}
      />
      {messages.value.write.safety}
    </label>
  );
}
