import { flightMessages } from '../messages/en-flights.js';
import { messages } from '../messages/index.js';
import type { Session } from '../session/session.js';
import { Choice } from '../ui/choice.js';
import { PERIODS } from './flight-filter.js';
import type { FlightLog } from './flight-log.js';
import './filter-bar.css';

interface FilterBarProps {
  readonly session: Session;
  readonly log: FlightLog;
}

/** Chooses which flights of the log are shown. */
export function FilterBar({ session, log }: FilterBarProps) {
  const { filter: words } = flightMessages;
  const { search } = messages.value.label;
  const filter = log.filter.value;
  const name = nameOf(session, log);
  return (
    <search class="flight-filter" aria-label={search}>
      <label class="field">
        <span>{search}</span>
        <input
          type="search"
          autocomplete="off"
          value={filter.text}
          onInput={({ currentTarget }) => log.narrow({ text: currentTarget.value })}
        />
      </label>
      <Choice
        label={words.period}
        choices={PERIODS}
        nameOf={(period) => words.periods[period]}
        chosen={filter.period}
        onChoose={(period) => log.narrow({ period })}
      />
      {name && <p>{words.of(name)}</p>}
    </search>
  );
}

/** The name of the model or the saved program whose flights are shown; in the log it stays when that is gone. */
function nameOf({ library }: Session, log: FlightLog): string | null {
  const { model, setting } = log.filter.value;
  const of = (id: string, field: 'model' | 'setting') =>
    library.flights.list.value.find(({ flight }) => flight[field] === id)?.flight;
  if (setting !== null)
    return library.settings.get(setting)?.setting.name ?? of(setting, 'setting')?.settingName ?? null;
  return model && (library.models.get(model)?.model.name ?? of(model, 'model')?.modelName ?? null);
}
