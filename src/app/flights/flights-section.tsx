import { useEffect } from 'preact/hooks';
import { moreMessages } from '../messages/more.js';
import type { Session } from '../work/session.js';
import { type FlownBy, NO_FILTER } from './flight-filter.js';
import { filtered } from './flight-list.js';
import type { FlightLog } from './flight-log.js';
import { TotalsLine } from './totals-line.js';

interface FlightsSectionProps {
  readonly session: Session;
  readonly log: FlightLog;
  readonly of: FlownBy;
  /** Opens the log. */
  readonly onAll: () => void;
}

/** The flights of a model or a setting, where there are some: their totals, and the way to them. */
export function FlightsSection({ session, log, of, onAll }: FlightsSectionProps) {
  const words = moreMessages.value.flights;
  const { flights } = session.library;
  useEffect(() => void flights.load(), [flights]);
  const records = filtered(flights.list.value, { ...NO_FILTER, of });
  if (records.length === 0 && !flights.failed.value) return null;
  return (
    <section class="stack">
      <h2>{words.title}</h2>
      {records.length === 0 ? (
        <p class="hint">{words.failed}</p>
      ) : (
        <>
          <TotalsLine records={records} />
          <div class="buttons">
            <button
              type="button"
              onClick={() => {
                log.showOnly({ of });
                onAll();
              }}
            >
              {words.section.all}
            </button>
          </div>
        </>
      )}
    </section>
  );
}
