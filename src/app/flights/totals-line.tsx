import { flightMessages } from '../messages/flights.js';
import type { FlightRecord } from '../storage/index.js';
import { totalsOf } from './flight-list.js';
import { resultText } from './flight-text.js';

/** How many flights, the best, the average, and the full rounds: in one line. */
export function TotalsLine({ records }: { readonly records: readonly FlightRecord[] }) {
  const { totals: words } = flightMessages.value;
  const { flights, best, average, rounds, maxima } = totalsOf(records);
  return (
    <p class="flight-totals">
      <strong>{words.flights(flights)}</strong>
      {best !== null && <span>{words.best(resultText(best))}</span>}
      {average !== null && <span>{words.average(resultText(Math.round(average)))}</span>}
      {rounds > 0 && <span>{words.maxima(maxima, rounds)}</span>}
    </p>
  );
}
