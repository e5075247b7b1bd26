import { dotted } from '../messages/dotted.js';
import { flightMessages } from '../messages/en-flights.js';
import { dtText, messages } from '../messages/index.js';
import type { FlightRecord } from '../storage/index.js';
import type { ShortDt } from '../work/short-dt.js';
import { type FlightDay, isFull } from './flight-list.js';
import { clockOf, dayHeading, resultText } from './flight-text.js';
import { measureText } from './measures.js';
import './flight-rows.css';

interface FlightRowsProps {
  readonly days: readonly FlightDay[];
  readonly shortDt: ShortDt;
  readonly onOpen: (key: string) => void;
}

/** The flights by day and place. The browser skips the drawing of those far from the window. */
export function FlightRows({ days, ...props }: FlightRowsProps) {
  const { totals } = flightMessages;
  return (
    <div class="stack">
      {days.map(({ key, latest, place, records }) => {
        const title = dotted([dayHeading(latest), place]);
        return (
          <section class="flight-day" key={key} aria-label={title}>
            <h2>
              <span>{title}</span> {/* Of a single day, the totals above say the same. */}
              {days.length > 1 && <small>{totals.flights(records.length)}</small>}
            </h2>
            <ul class="ruled">
              {records.map((record) => (
                <Row key={record.key} record={record} {...props} />
              ))}
            </ul>
          </section>
        );
      })}
    </div>
  );
}

interface RowProps extends Omit<FlightRowsProps, 'days'> {
  readonly record: FlightRecord;
}

function Row({ record: { key, flight }, shortDt, onOpen }: RowProps) {
  const { row: words } = flightMessages;
  const { wind, temperature, round, result, note, program } = flight;
  const facts = [
    round === '' ? null : words.round(round),
    wind === null ? null : words.wind(measureText(wind)),
    temperature === null ? null : words.temperature(measureText(temperature)),
    note.split('\n')[0] || null,
  ];
  return (
    <li>
      <button type="button" class="flight-row" onClick={() => onOpen(key)}>
        <span class="flight-time">{clockOf(flight)}</span>
        <span class="flight-what">
          <b>{flight.modelName || messages.value.noModel}</b>
          {flight.settingName && `\u00a0· ${flight.settingName}`}
        </span>
        {facts.some(Boolean) && <small class="flight-facts">{dotted(facts)}</small>}
        <span class="flight-end">
          {result === null ? (
            <small>{words.noResult}</small>
          ) : (
            <b class={isFull(flight) ? 'full' : undefined}>{resultText(result)}</b>
          )}
          {shortDt.isShort(program) && (
            <small class="bad-text">
              {messages.value.program.dt} {dtText(program.times[program.identity.functions] as number)}
            </small>
          )}
        </span>
      </button>
    </li>
  );
}
