import { messages } from '../messages/index.js';
import type { ServoMoves } from '../session/servo-moves.js';

/** Asks whether a write may move the servos. Only of a timer that keeps positions nowhere else. */
export function MoveServosCheck({ servoMoves }: { readonly servoMoves: ServoMoves }) {
  const { move } = messages.value.write;
  if (!servoMoves.needed) return null;
  return (
    <div class="notice">
      <p>{move.why}</p>
      <label class="check">
        <input
          type="checkbox"
          checked={servoMoves.allowed.value}
          aria-describedby="move-servos-hint"
          onChange={(event) => servoMoves.allow(event.currentTarget.checked)}
        />
        {move.label}
      </label>
      <p id="move-servos-hint">
        <strong>{move.hint}</strong>
      </p>
    </div>
  );
}
