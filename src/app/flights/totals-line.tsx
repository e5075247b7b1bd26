import { moreMessages } from '../messages/more.js';
import type { FlightRecord } from '../storage/index.js';
import { totalsOf } from './flight-list.js';
import { resultText } from './flight-text.js';

/** One line: how many flights, the best, and the average. */
export function TotalsLine({ records }: { readonly records: readonly FlightRecord[] }) {
  const { totals: words } = moreMessages.value.flights;
  const { flights, best, average } = totalsOf(records);
  return (
    <p class="row flight-totals">
      <strong>{words.flights({ count: flights })}</strong>
      {best !== null && <span>{words.best({ time: resultText(best) })}</span>}
      {average !== null && <span>{words.average({ time: resultText(average) })}</span>}
    </p>
  );
}
