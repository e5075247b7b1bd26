import { useSignal } from '@preact/signals';
import * as v from 'valibot';
import { saveFile } from '../browser/save-file.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import { flightMessages } from '../messages/en-flights.js';
import type { FlightRecord } from '../storage/index.js';
import { Choice } from '../ui/choice.js';
import { dayOf } from './flight-list.js';
import { flightsCsv, SEPARATORS, type Separator } from './flights-csv.js';
import './csv-export.css';

/** The setting that keeps which separator the pilot's spreadsheet uses. */
const CHOICE = 'csv-separator';

/** Saves the flights that are shown as a table for a spreadsheet. */
export function CsvExport({ records }: { readonly records: readonly FlightRecord[] }) {
  const { csv: words } = flightMessages;
  const separator = useSignal<Separator>(loadSetting(CHOICE, v.picklist(SEPARATORS)) ?? ';');
  const choose = (chosen: Separator): void => {
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
      <Choice
        label={words.separator}
        choices={SEPARATORS}
        nameOf={(each) => words.separators[each]}
        chosen={separator.value}
        onChoose={choose}
      />
      <button type="button" disabled={records.length === 0} onClick={save}>
        {words.save}
      </button>
    </div>
  );
}
