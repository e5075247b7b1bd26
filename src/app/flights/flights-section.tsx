import { useEffect } from 'preact/hooks';
import { flightMessages } from '../messages/en-flights.js';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { type FlightFilter, NO_FILTER } from './flight-filter.js';
import { filtered } from './flight-list.js';
import type { FlightLog } from './flight-log.js';
import { Row } from './flight-rows.js';
import { TotalsLine } from './totals-line.js';
import './flights-section.css';

interface FlightsSectionProps {
  readonly session: Session;
  readonly log: FlightLog;
  /** Whose flights: those of a model or of a setting, by its id. */
  readonly of: Pick<FlightFilter, 'model'> | Pick<FlightFilter, 'setting'>;
  /** Opens the log. */
  readonly onAll: () => void;
}

/** How many of the latest flights stand on the page of a model or a setting. */
const SOME = 5;

/** The flights of a model or a setting: the latest, the totals, and a link to all of them. */
export function FlightsSection({ session, log, of, onAll }: FlightsSectionProps) {
  const words = flightMessages;
  const { flights } = session.library;
  useEffect(() => void flights.load(), [flights]);
  const showAll = (): void => {
    log.showOnly(of);
    onAll();
  };
  const records = filtered(flights.list.value, { ...NO_FILTER, ...of }, 0);
  // A setting stands beside its model, which says that there is none.
  if ('setting' in of && records.length === 0 && !flights.failed.value) return null;
  return (
    <section class="stack flights-of">
      <h2>{words.title}</h2>
      {records.length === 0 ? (
        <p class="hint">
          {flights.failed.value ? words.failed : flights.loaded.value ? words.empty.title : messages.value.parts.coming}
        </p>
      ) : (
        <>
          <TotalsLine records={records} />
          <ul>
            {records.slice(0, SOME).map((record) => (
              <Row
                key={record.key}
                record={record}
                shortDt={session.shortDt}
                onOpen={(key) => log.fillIn(key)}
                of={'model' in of ? 'model' : 'setting'}
              />
            ))}
          </ul>
          <div class="buttons">
            <button type="button" onClick={showAll}>
              {words.section.all}
            </button>
          </div>
        </>
      )}
    </section>
  );
}
