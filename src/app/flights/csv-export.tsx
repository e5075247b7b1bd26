import { saveFile } from '../browser/save-file.js';
import { flightMessages } from '../messages/en-flights.js';
import type { FlightRecord } from '../storage/index.js';
import { dayOf } from './flight-list.js';
import { flightsCsv, marksOf } from './flights-csv.js';

/** Saves the flights that are shown as a table for a spreadsheet, in the way of the browser's language. */
export function CsvExport({ records }: { readonly records: readonly FlightRecord[] }) {
  const { csv: words } = flightMessages;
  const save = (): void => {
    const flights = records.map(({ flight }) => flight);
    const text = flightsCsv(flights, { marks: marksOf(), heads: words.columns });
    saveFile(`flights-${dayOf({ at: Date.now() })}.csv`, text, 'text/csv');
  };
  return (
    <button type="button" disabled={records.length === 0} onClick={save}>
      {words.save}
    </button>
  );
}
