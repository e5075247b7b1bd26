import { messages } from '../messages/index.js';
import type { ServoMoves } from '../timer/servo-moves.js';
import { Check } from '../ui/check.js';

/** Asks whether a write may move the servos. Only for a timer that keeps positions where the servos stand. */
export function MoveServosCheck({ servoMoves }: { readonly servoMoves: ServoMoves }) {
  const { move } = messages.value.write;
  if (!servoMoves.needed) return null;
  return (
    <div class="notice">
      <p>{move.why}</p>
      <Check checked={servoMoves.allowed.value} onChange={(checked) => servoMoves.allow(checked)}>
        {/* In the label: what follows the box may lie behind the buttons when it is ticked. */}
        <span>
          {move.label} <strong>{move.hint}</strong>
        </span>
      </Check>
    </div>
  );
}
