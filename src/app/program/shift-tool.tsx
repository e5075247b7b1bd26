import { useSignal } from '@preact/signals';
import { slotCount } from '../../protocol/index.js';
import type { Editor } from '../editing/editor.js';
import { shiftFrom } from '../editing/edits.js';
import { parseInterval } from '../editing/units.js';
import { messages, obstacleText, slotLabel } from '../messages/index.js';
import './tool-fields.css';

/** Moves a function and all later ones in time. */
export function ShiftTool({ editor }: { readonly editor: Editor }) {
  const { shift, nothingDone } = messages.value.edits;
  const from = useSignal(1);
  const amount = useSignal('0.50');
  const moveDt = useSignal(false);
  const problem = useSignal<string | null>(null);
  const identity = editor.identity.value;
  if (!identity) return null;
  const first = identity.timerClass === 'Q' ? 0 : 1;
  const slots = Array.from({ length: slotCount(identity) }, (_, slot) => slot).slice(first);
  const slot = Math.min(Math.max(from.value, first), identity.functions);

  const move = (direction: 1 | -1): void => {
    const parsed = parseInterval(amount.value);
    if ('unreadable' in parsed) {
      problem.value = messages.value.unreadable[parsed.unreadable];
      return;
    }
    const by = direction * parsed.value;
    const working = editor.working.value;
    if (!working) return;
    const obstacle = editor.apply(shiftFrom(working, slot, by, { moveDt: moveDt.value }));
    problem.value = obstacle && `${nothingDone} ${obstacleText(identity, obstacle)}`;
  };
  return (
    <details class="tool">
      <summary>{shift.title}</summary>
      <div class="tool-fields">
        <label>
          {shift.from}
          <select
            value={slot}
            onChange={(event) => {
              from.value = Number(event.currentTarget.value);
            }}
          >
            {slots.map((each) => (
              <option key={each} value={each}>
                {slotLabel(identity, each)}
              </option>
            ))}
          </select>
        </label>
        <label>
          {shift.by}
          <input
            type="text"
            inputMode="decimal"
            autocomplete="off"
            value={amount.value}
            onInput={(event) => {
              amount.value = event.currentTarget.value;
              problem.value = null;
            }}
          />
        </label>
        <label class="check">
          <input
            type="checkbox"
            checked={moveDt.value}
            onChange={(event) => {
              moveDt.value = event.currentTarget.checked;
            }}
          />
          {shift.moveDt}
        </label>
        <div class="buttons">
          <button type="button" onClick={() => move(-1)}>
            {shift.earlier}
          </button>
          <button type="button" onClick={() => move(1)}>
            {shift.later}
          </button>
        </div>
      </div>
      {problem.value && (
        <p class="notes bad-text" role="alert">
          {problem.value}
        </p>
      )}
    </details>
  );
}
