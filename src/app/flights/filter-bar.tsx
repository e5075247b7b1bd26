import type { ComponentChildren } from 'preact';
import { flightMessages } from '../messages/en-flights.js';
import type { Session } from '../session/session.js';
import { Select } from '../ui/choice.js';
import { type ModelFilter, PERIODS } from './flight-filter.js';
import { modelsOf, placesOf } from './flight-list.js';
import type { FlightLog } from './flight-log.js';
import './filter-bar.css';

interface FilterBarProps {
  readonly session: Session;
  readonly log: FlightLog;
}

/** Chooses which flights of the log are shown. */
export function FilterBar({ session, log }: FilterBarProps) {
  const { filter: words } = flightMessages;
  const { flights, models, settings } = session.library;
  const filter = log.filter.value;
  const list = flights.list.value;
  const names = modelsOf(list);
  const places = placesOf(list);
  const settingName =
    filter.setting &&
    (settings.get(filter.setting)?.setting.name ??
      list.find(({ flight }) => flight.setting === filter.setting)?.flight.settingName);
  return (
    <search class="flight-filter" aria-label={words.title}>
      <Choice label={words.text}>
        <input
          type="search"
          autocomplete="off"
          value={filter.text}
          onInput={({ currentTarget }) => log.narrow({ text: currentTarget.value })}
        />
      </Choice>
      <Choice label={words.model}>
        <select
          value={modelKey(filter.model)}
          onChange={({ currentTarget }) => log.narrow({ model: modelOf(currentTarget.value) })}
        >
          <option value="all">{words.allModels}</option>
          {[...names].map(([id, name]) => (
            <option key={id} value={`id ${id}`}>
              {models.get(id)?.model.name ?? name}
            </option>
          ))}
          {typeof filter.model === 'object' && !names.has(filter.model.id) && (
            <option value={modelKey(filter.model)}>{models.get(filter.model.id)?.model.name}</option>
          )}
          <option value="none">{words.noModel}</option>
        </select>
      </Choice>
      <Choice label={words.place}>
        <select
          value={filter.place === null ? 'all' : `in ${filter.place}`}
          onChange={({ currentTarget: { value } }) => log.narrow({ place: value === 'all' ? null : value.slice(3) })}
        >
          <option value="all">{words.allPlaces}</option>
          {filter.place !== null && !places.includes(filter.place) && filter.place !== '' && (
            <option value={`in ${filter.place}`}>{filter.place}</option>
          )}
          {places.map((place) => (
            <option key={place} value={`in ${place}`}>
              {place}
            </option>
          ))}
          <option value="in ">{words.noPlace}</option>
        </select>
      </Choice>
      <Choice label={words.period}>
        <Select
          choices={PERIODS}
          nameOf={(period) => words.periods[period]}
          chosen={filter.period}
          onChoose={(period) => log.narrow({ period })}
        />
      </Choice>
      {filter.period === 'own' &&
        (['from', 'until'] as const).map((end) => (
          <Choice key={end} label={words[end]}>
            <input
              type="date"
              value={filter[end]}
              onChange={({ currentTarget }) => log.narrow({ [end]: currentTarget.value })}
            />
          </Choice>
        ))}
      {settingName && <p>{words.setting(settingName)}</p>}
    </search>
  );
}

function Choice({ label, children }: { readonly label: string; readonly children: ComponentChildren }) {
  return (
    // biome-ignore lint/a11y/noLabelWithoutControl: the control is what is inside.
    <label>
      <span>{label}</span>
      {children}
    </label>
  );
}

function modelKey(model: ModelFilter): string {
  return typeof model === 'object' ? `id ${model.id}` : model;
}

function modelOf(key: string): ModelFilter {
  if (key === 'all' || key === 'none') return key;
  return { id: key.slice(3) };
}
