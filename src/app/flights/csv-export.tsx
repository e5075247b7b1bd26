import { useSignal } from '@preact/signals';
import * as v from 'valibot';
import { saveFile } from '../browser/save-file.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import { flightMessages } from '../messages/flights.js';
import type { FlightRecord } from '../storage/index.js';
import { dayOf } from './flight-list.js';
import { flightsCsv, SEPARATORS, type Separator } from './flights-csv.js';
import './csv-export.css';

/** The setting that keeps which separator the pilot's spreadsheet uses. */
const CHOICE = 'csv-separator';

/** Saves the flights that are shown as a table for a spreadsheet. */
export function CsvExport({ records }: { readonly records: readonly FlightRecord[] }) {
  const { csv: words } = flightMessages.value;
  const separator = useSignal<Separator>(loadSetting(CHOICE, v.picklist(SEPARATORS)) ?? ';');
  const choose = (text: string): void => {
    const chosen = SEPARATORS.find((each) => each === text);
    if (!chosen) return;
    separator.value = chosen;
    saveSetting(CHOICE, chosen);
  };
  const save = (): void => {
    const flights = records.map(({ flight }) => flight);
    const text = flightsCsv(flights, { separator: separator.value, heads: words.columns });
    saveFile(`flights-${dayOf(Date.now())}.csv`, text, 'text/csv');
  };
  return (
    <div class="csv-export">
      <label>
        <span>{words.separator}</span>
        <select value={separator.value} onChange={({ currentTarget }) => choose(currentTarget.value)}>
          {SEPARATORS.map((each) => (
            <option key={each} value={each}>
              {words.separators[each]}
            </option>
          ))}
        </select>
      </label>
      <button type="button" disabled={records.length === 0} onClick={save}>
        {words.save}
      </button>
    </div>
  );
}
