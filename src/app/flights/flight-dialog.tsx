import { useEffect, useId, useRef } from 'preact/hooks';
import { type Flight, LIMITS } from '../../program/index.js';
import { dotted, whole } from '../messages/dotted.js';
import { dtText, messages, shortDtText } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import { ProgramGrid } from '../timeline/program-grid.js';
import { Choice } from '../ui/choice.js';
import { Modal } from '../ui/modal.js';
import { OpenButton } from '../ui/open-button.js';
import type { Session } from '../work/session.js';
import { dayOf, momentOf, nextRound, placesOf, timeOfDay } from './flight-list.js';
import type { FlightLog } from './flight-log.js';
import { clockOf, dayHeading, heldText, resultText, roundText } from './flight-text.js';
import { measureText, RANGES } from './measures.js';
import { Stepper } from './stepper.js';
import { useTypedMeasure } from './typed-measure.js';
import './flight-dialog.css';

interface FlightDialogProps {
  readonly session: Session;
  readonly log: FlightLog;
  /** Shows the program that was opened. */
  readonly onProgram: () => void;
}

/** A form for one flight, for cold hands. What pilots note first stands first. */
export function FlightDialog({ session, log, onProgram }: FlightDialogProps) {
  const { form: words } = moreMessages.value.flights;
  const { flights, models } = session.library;
  const key = log.filling.value;
  const flight = flights.get(key)?.flight;
  useEffect(() => {
    // Loads the models to choose from, and the log with its places and the flight before.
    if (key !== null) void Promise.all([models.load(), flights.load()]);
  }, [key, models, flights]);
  return (
    <Modal open={flight !== undefined} title={words.title} onEscape={() => leaveForm(log)}>
      {flight && <Form key={flight.id} {...{ flight, session, log, onProgram }} />}
    </Modal>
  );
}

/** Closes the form with what was typed last. */
function leaveForm(log: FlightLog): void {
  if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
  log.close();
}

interface FormProps extends FlightDialogProps {
  readonly flight: Flight;
}

/** What parts of the form need. A change goes into the log at once, so nothing typed is lost. */
interface PartProps extends Pick<FormProps, 'session' | 'flight'> {
  readonly change: (changes: Partial<Flight>) => void;
}

function Form({ flight, session, log, onProgram }: FormProps) {
  const { form: words, flying } = moreMessages.value.flights;
  const { delete: remove, done: doneLabel, label, noModel } = messages.value;
  const box = useRef<HTMLFormElement>(null);
  const change = (changes: Partial<Flight>): void => void log.change(flight.id, changes);
  const wind = useTypedMeasure('wind', flight.wind, (value) => change({ wind: value }));
  const temperature = useTypedMeasure('temperature', flight.temperature, (value) => change({ temperature: value }));
  const done = (event: Event): void => {
    event.preventDefault();
    // Done first leads to a text that cannot be read; Escape closes the form with it.
    const wrong = box.current?.querySelector<HTMLElement>('[aria-invalid="true"]');
    if (wrong) wrong.focus();
    else leaveForm(log);
  };
  return (
    <form class="stack gap-4 flight-form" ref={box} noValidate onSubmit={done}>
      <p class="stack gap-1">
        <strong>{dotted([flight.modelName || noModel, flight.settingName])}</strong>
        <span>{heldText(flight.program)}</span>
        <span class="hint">{dotted([dayHeading(flight), clockOf(flight), flight.place])}</span>
      </p>
      <Result {...{ session, flight, change }} />
      <Proposed {...{ session, flight, change }} />
      <Round {...{ flight, change }} />
      <ShortDtNote {...{ session, log, flight }} />
      <div class="stack">
        <Stepper field={wind} label={words.wind} first={() => firstOf('wind', session, flight)} />
        <Stepper field={temperature} label={words.temperature} first={() => firstOf('temperature', session, flight)} />
      </div>
      <label class="field">
        <span>{label.note}</span>
        <textarea
          rows={2}
          maxLength={LIMITS.note}
          value={flight.note}
          onInput={({ currentTarget }) => change({ note: currentTarget.value })}
        />
      </label>
      <Where {...{ session, flight, change }} />
      {/* A copy that nothing changes any more. */}
      <details>
        <summary>{words.flown}</summary>
        <ProgramGrid program={flight.program} caption={messages.value.program.tableCaption} />
      </details>
      <div class="buttons">
        <button type="button" class="quiet" onClick={() => log.remove(flight.id)}>
          {remove}
        </button>
        <button type="button" class="quiet" onClick={() => log.fillIn(log.flyAgain(flight))}>
          {flying.again}
        </button>
        <OpenButton
          label={words.open}
          obstacle={session.opened.obstacle(flight.program)}
          open={() => log.showFlown(flight)}
          onProgram={() => {
            log.close();
            onProgram();
          }}
        />
      </div>
      <div class="buttons">
        <button type="submit" class="primary">
          {doneLabel}
        </button>
      </div>
    </form>
  );
}

/** The flights of the day before this one, the latest first. */
function before({ library }: Session, flight: Flight): readonly Flight[] {
  const all = library.flights.list.value.map((record) => record.flight);
  return all.filter((each) => each.at < flight.at && dayOf(each) === dayOf(flight));
}

/** What was noted last on the same day, because wind and temperature change slowly; null for nothing. */
function lastOf(measure: 'wind' | 'temperature' | 'result', session: Session, flight: Flight): number | null {
  return before(session, flight).find((each) => each[measure] !== null)?.[measure] ?? null;
}

function firstOf(measure: 'wind' | 'temperature' | 'result', session: Session, flight: Flight): number {
  return lastOf(measure, session, flight) ?? RANGES[measure].first;
}

/** The next round of the model and the last wind of the day, to note with one tap. */
function Proposed({ session, flight, change }: PartProps) {
  const { form: words, row } = moreMessages.value.flights;
  if (flight.round !== '' || flight.wind !== null) return null;
  const rounds = before(session, flight).filter(({ round }) => round !== '');
  const round = nextRound((rounds.find(({ model }) => model === flight.model) ?? rounds[0])?.round ?? '');
  const wind = lastOf('wind', session, flight);
  if (round === '' && wind === null) return null;
  const facts = [round && roundText(round), wind !== null && row.wind({ wind: measureText(wind) })];
  return (
    <button type="button" class="chip" onClick={() => change({ round, wind })}>
      {words.propose({ facts: dotted(facts) })}
    </button>
  );
}

/** A full round of most classes, in seconds. */
const FULL_ROUND = 180;

function Result({ session, flight, change }: PartProps) {
  const { form: words } = moreMessages.value.flights;
  const field = useTypedMeasure('result', flight.result, (result) => change({ result }));
  return (
    <div class="stack">
      <Stepper field={field} label={words.result} first={() => firstOf('result', session, flight)} />
      <div class="row">
        <button
          type="button"
          class="chip"
          aria-pressed={field.value === FULL_ROUND}
          onClick={() => field.take(FULL_ROUND)}
        >
          {words.full}
        </button>
        <span class="hint">{field.value === null ? words.resultHint : understood(field.value)}</span>
      </div>
    </div>
  );
}

/** The result as it was understood: in minutes, and in seconds where those look different. */
function understood(result: number): string {
  const { form: words } = moreMessages.value.flights;
  const text = resultText(result);
  return result < 60 ? text : words.readAs({ time: text, seconds: measureText(result) });
}

/** The numbered rounds that have buttons. */
const ROUNDS: readonly string[] = ['1', '2', '3', '4', '5'];

function Round({ flight: { round }, change }: Omit<PartProps, 'session'>) {
  const { form: words } = moreMessages.value.flights;
  return (
    <fieldset class="stack gap-1">
      <legend class="hint">{words.round}</legend>
      <span class="row flight-rounds">
        {[...ROUNDS, words.flyOff].map((value) => (
          <button
            type="button"
            class="chip"
            key={value}
            aria-pressed={round === value}
            onClick={() => change({ round: round === value ? '' : value })}
          >
            {value}
          </button>
        ))}
        <input
          type="text"
          autocomplete="off"
          aria-label={words.round}
          maxLength={LIMITS.round}
          value={round}
          onInput={({ currentTarget }) => change({ round: currentTarget.value })}
        />
      </span>
    </fieldset>
  );
}

/** A contest round with a short DT for trimming: asks before the flight, says so afterwards. */
function ShortDtNote({ session, log, flight }: Omit<FormProps, 'onProgram'>) {
  const { shortDt } = messages.value;
  const { form: words } = moreMessages.value.flights;
  const { identity, memory, times } = flight.program;
  const held = session.shortDt.held.value;
  if (flight.round === '' || !session.shortDt.isShort(flight.program)) return null;
  const dt = dtText(times[identity.functions] as number);
  const canPutBack = held !== null && log.canPutBack(flight);
  return (
    <div class="notice bad" role="alert">
      <p>
        {canPutBack ? (
          <>
            <strong>{shortDtText(memory === null ? null : memoryName(memory), dt)}</strong>{' '}
            {shortDt.ask({ back: whole(dtText(held.back)), remembered: held.remembered })}
          </>
        ) : (
          <strong>{words.shortDt({ dt })}</strong>
        )}
      </p>
      {canPutBack && (
        <button type="button" onClick={() => void log.putBack(flight.id)}>
          {shortDt.putBack({ back: whole(dtText(held.back)), remembered: held.remembered })}
        </button>
      )}
    </div>
  );
}

function Where({ session, flight, change }: PartProps) {
  const { form: words } = moreMessages.value.flights;
  const { label, noModel } = messages.value;
  const { models, flights } = session.library;
  const when = `${dayOf(flight)}T${timeOfDay(flight)}`;
  const places = useId();
  const listed = models.list.value.flatMap(({ model, key }) => (model.archived ? [] : key));
  return (
    <details>
      <summary>{words.when}</summary>
      <div class="stack gap-3">
        <label class="field">
          <span>{words.date}</span>
          <input
            type="datetime-local"
            required
            value={when}
            // While a year is typed, it is the year 2 for a moment.
            onBlur={({ currentTarget }) => {
              const at = momentOf(currentTarget.value, flight);
              if (currentTarget.value === when) return;
              if (at >= 0) change({ at });
              else currentTarget.value = when;
            }}
          />
          {flight.utcOffset === undefined && <span class="hint">{words.noOffset}</span>}
        </label>
        <label class="field">
          <span>{words.place}</span>
          <input
            type="text"
            list={places}
            autocomplete="off"
            maxLength={LIMITS.place}
            value={flight.place}
            onInput={({ currentTarget }) => change({ place: currentTarget.value })}
          />
        </label>
        <datalist id={places}>
          {placesOf(flights.list.value).map((place) => (
            <option key={place} value={place} />
          ))}
        </datalist>
        <Choice
          label={label.model}
          choices={[...new Set([null, flight.model, ...listed])]}
          nameOf={(key) => (key === null ? noModel : (models.get(key)?.model.name ?? flight.modelName))}
          chosen={flight.model}
          onChoose={(model) => change({ model, modelName: models.get(model)?.model.name ?? '' })}
        />
      </div>
    </details>
  );
}
