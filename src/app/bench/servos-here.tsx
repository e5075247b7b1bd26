import { useComputed } from '@preact/signals';
import { fieldKey } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { messages, slotInSentence } from '../messages/index.js';
import type { Bench } from './bench.js';
import { standText } from './bench-text.js';
import type { Follow } from './follow.js';
import './servos-here.css';

interface ServosHereProps {
  readonly bench: Bench;
  readonly follow: Follow;
  readonly slot: number;
}

/** While the servos follow: marks the function where they stand, if that is known. */
export function ServosHere({ bench, follow, slot }: ServosHereProps) {
  const here = useComputed(() => follow.on.value && bench.stand.at.value === slot).value;
  return here ? <span class="servos-here">{messages.value.bench.here}</span> : null;
}

interface ServosOfferProps {
  readonly bench: Bench;
  readonly follow: Follow;
  readonly identity: Identity;
  readonly slot: number;
  /** How many slots the table has. */
  readonly width: number;
}

/** Under a function with positions that wait for the servos: a button that brings them there. */
export function ServosOffer({ bench, follow, identity, slot, width }: ServosOfferProps) {
  const { bench: words } = messages.value;
  const waits = useComputed(() => follow.awaited.value.has(slot)).value;
  if (!waits) return null;
  return (
    <tr class="row-notes servos-offer">
      <td colSpan={width}>
        <div class="row">
          <p>
            {words.waits} {standText(identity, bench.stand.at.value)}
          </p>
          <button
            type="button"
            onClick={({ currentTarget, detail }) => {
              // The button goes away, so the focus goes back to the field.
              const field = follow.waitingAt(slot);
              const input = field && currentTarget.closest('table')?.querySelector(`[data-field='${fieldKey(field)}']`);
              follow.bring(slot);
              if (detail === 0 && input instanceof HTMLElement) input.focus();
            }}
          >
            {words.bring({ slot: slotInSentence(identity, slot) })}
          </button>
        </div>
      </td>
    </tr>
  );
}
