import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { Choice } from '../ui/choice.js';
import { PERIODS } from './flight-filter.js';
import type { FlightLog } from './flight-log.js';
import './filter-bar.css';

/** Chooses which flights of the log are shown. */
export function FilterBar({ log }: { readonly log: FlightLog }) {
  const { filter: words } = moreMessages.value.flights;
  const { search } = messages.value.label;
  const filter = log.filter.value;
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
      {filter.of && <p>{words.of({ name: filter.of.name })}</p>}
    </search>
  );
}
