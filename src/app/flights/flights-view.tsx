import { useEffect, useLayoutEffect, useMemo } from 'preact/hooks';
import { saveFile } from '../browser/save-file.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import type { FlightRecord } from '../storage/index.js';
import { BackHead } from '../ui/back-head.js';
import type { Session } from '../work/session.js';
import { NO_FILTER } from './flight-filter.js';
import { dayOf, filtered, flownBefore, grouped } from './flight-list.js';
import type { FlightLog } from './flight-log.js';
import { FlightRows } from './flight-rows.js';
import { flightsCsv, marksOf } from './flights-csv.js';
import { FlyingThis } from './flying-this.js';
import { TotalsLine } from './totals-line.js';
import './flights-view.css';

export interface FlightsViewProps {
  readonly session: Session;
  readonly log: FlightLog;
}

/** From how many flights on a filter is of use. */
const MANY = 10;

/** The log of flights with its filter and totals: newest first, by day and place. */
export function FlightsView({ session, log }: FlightsViewProps) {
  const words = moreMessages.value.flights;
  const { label, parts, views } = messages.value;
  const { library } = session;
  const { list, loaded, failed } = library.flights;
  useLayoutEffect(() => {
    // The pilot may come from further down in the library. The view itself remembers the place inside the log.
    document.documentElement.scrollTop = 0;
  }, []);
  useEffect(() => {
    void library.flights.load();
    void library.load();
  }, [library]);
  const filter = log.filter.value;
  // Of the whole log: a filter hides flights, but they were flown.
  const before = useMemo(() => flownBefore(list.value), [list.value]);
  const shown = filtered(list.value, filter);
  return (
    <div class="stack gap-3 flights">
      <BackHead back={views.names.library} to="#library">
        {words.title}
      </BackHead>
      <FlyingThis session={session} log={log} again />
      {!loaded.value && list.value.length === 0 && (
        <p class="hint" role="status">
          {parts.coming}
        </p>
      )}
      {failed.value && (
        <div class="notice bad" role="alert">
          <p>{words.failed}</p>
          <button type="button" onClick={() => void library.flights.load()}>
            {parts.again}
          </button>
        </div>
      )}
      {loaded.value && !failed.value && list.value.length === 0 && (
        <div class="stack flights-empty">
          <p>
            <strong>{words.empty.title}</strong>
          </p>
          <p class="hint">{words.empty.advice}</p>
        </div>
      )}
      {list.value.length > 0 && (
        <>
          {/* A part of a day would have a wrong total. */}
          {filter.day === null && (list.value.length >= MANY || filter !== NO_FILTER) && (
            <search class="stack" aria-label={label.search}>
              <label class="field">
                <span>{label.search}</span>
                <input
                  type="search"
                  autocomplete="off"
                  value={filter.text}
                  onInput={({ currentTarget }) => log.showOnly({ of: filter.of, text: currentTarget.value })}
                />
              </label>
              {filter.of && <p>{words.filter.of({ name: filter.of.name })}</p>}
            </search>
          )}
          <div class="row between flights-sum">
            <TotalsLine records={shown} />
            {shown.length < list.value.length && (
              <button type="button" class="quiet" onClick={() => log.showOnly()}>
                {words.filter.clear}
              </button>
            )}
          </div>
          {loaded.value && (
            <div class="buttons">
              <button type="button" disabled={shown.length === 0} onClick={() => saveTable(shown)}>
                {words.csv.save}
              </button>
            </div>
          )}
          <FlightRows days={grouped(shown)} before={before} shortDt={session.shortDt} log={log} />
        </>
      )}
    </div>
  );
}

/** As a table for a spreadsheet. */
function saveTable(records: readonly FlightRecord[]): void {
  const text = flightsCsv(
    records.map(({ flight }) => flight),
    marksOf(),
  );
  saveFile(`flights-${dayOf({ at: Date.now() })}.csv`, text, 'text/csv');
}
