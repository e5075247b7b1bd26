import { messages } from '../messages/index.js';
import { useModels } from '../models.js';

/** Asks whether a write may move the servos. Only of a timer that keeps positions nowhere else. */
export function MoveServosCheck() {
  const { session } = useModels();
  const { move } = messages.value.write;
  const { servoMoves } = session;
  if (!servoMoves.needed) return null;
  return (
    <div class="notice">
      <p>{move.why}</p>
      <label class="check">
        <input
          type="checkbox"
          checked={servoMoves.allowed.value}
          aria-describedby="move-servos-hint"
          onChange={(event) => (servoMoves.allowed.value = event.currentTarget.checked)}
        />
        {move.label}
      </label>
      <p id="move-servos-hint">
        <strong>{move.hint}</strong>
      </p>
    </div>
  );
}
