import { messages } from '../messages/index.js';
import type { Safety } from '../timer/safety.js';
import './safety-check.css';

/** Asked once for each connection, before anything is written or moved. */
export function SafetyCheck({ safety }: { readonly safety: Safety }) {
  return (
    <label class="check safety">
      <input
        type="checkbox"
        checked={safety.confirmed.value}
        onChange={(event) => (event.currentTarget.checked ? safety.confirm() : safety.withdraw())}
      />
      {messages.value.write.safety}
    </label>
  );
}
