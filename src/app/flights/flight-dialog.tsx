import { useEffect, useId, useMemo, useRef } from 'preact/hooks';
import { LIMITS } from '../../program/index.js';
import { dotted, whole } from '../messages/dotted.js';
import { dtText, messages, shortDtText } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import { ProgramGrid } from '../timeline/program-grid.js';
import { Choice } from '../ui/choice.js';
import { Modal } from '../ui/modal.js';
import { OpenButton } from '../ui/open-button.js';
import { Problem } from '../ui/problem.js';
import { TimeQuestion } from '../ui/time-question.js';
import type { Session } from '../work/session.js';
import { FlightForm } from './flight-form.js';
import { placesOf, ROUND_MAXIMUM } from './flight-list.js';
import type { FlightLog } from './flight-log.js';
import { clockOf, dayHeading, heldText, resultText, roundText } from './flight-text.js';
import { measureText } from './measures.js';
import { Stepper } from './stepper.js';
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
  const isHere = flights.get(key) !== undefined;
  useEffect(() => {
    // Loads the models to choose from, and the log with its places and the flight before.
    if (key !== null) void Promise.all([models.load(), flights.load()]);
  }, [key, models, flights]);
  return (
    <Modal open={isHere} title={words.title} onEscape={() => log.close()}>
      {key !== null && isHere && <Form key={key} id={key} {...{ session, log, onProgram }} />}
    </Modal>
  );
}

interface FormProps extends FlightDialogProps {
  /** The key of the flight. */
  readonly id: string;
}

function Form({ id, session, log, onProgram }: FormProps) {
  const { form: words, flying } = moreMessages.value.flights;
  const { delete: remove, done: doneLabel, label, noModel } = messages.value;
  const { flights } = session.library;
  const form = useMemo(() => {
    const list = flights.list.peek();
    const at = list.findIndex(({ key }) => key === id);
    const opened = list[at];
    const before = list.slice(at + 1).map(({ flight }) => flight);
    return opened ? new FlightForm(log, opened.flight, before) : null;
  }, [id, log, flights]);
  const box = useRef<HTMLFormElement>(null);
  if (!form) return null;
  const flight = form.flight.value;
  const done = (event: Event): void => {
    event.preventDefault();
    // Done first leads to a text that cannot be read; Escape closes the form with it.
    const wrong = box.current?.querySelector<HTMLElement>('[aria-invalid="true"]');
    if (wrong) wrong.focus();
    else log.close();
  };
  return (
    <form class="stack gap-4 flight-form" ref={box} noValidate onSubmit={done}>
      <p class="stack gap-1">
        <strong>{dotted([flight.modelName || noModel, flight.settingName])}</strong>
        <span>{heldText(flight.program)}</span>
        <span class="hint">{dotted([dayHeading(flight), clockOf(flight), flight.place])}</span>
      </p>
      <Result form={form} />
      <Proposed form={form} />
      <Round form={form} />
      <ShortDtNote {...{ session, log, form, id }} />
      <div class="stack">
        <Stepper form={form} measure="wind" label={words.wind} unit={words.windUnit} />
        <Stepper form={form} measure="temperature" label={words.temperature} unit={words.temperatureUnit} />
      </div>
      <label class="field">
        <span>{label.note}</span>
        <textarea
          rows={2}
          maxLength={LIMITS.note}
          value={flight.note}
          onInput={({ currentTarget }) => form.set({ note: currentTarget.value })}
        />
      </label>
      <Where session={session} form={form} />
      <Flown form={form} />
      <div class="buttons">
        <button type="button" class="quiet" onClick={() => log.remove(id)}>
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

function Result({ form }: { readonly form: FlightForm }) {
  const { form: words } = moreMessages.value.flights;
  const field = useId();
  const { result } = form.flight.value;
  return (
    <div class="stack">
      <Stepper form={form} measure="result" label={words.result} unit={messages.value.times.units.s} field={field} />
      {form.either.value && (
        <TimeQuestion
          label={words.result}
          either={form.either.value}
          onAnswer={(value, byKey) => {
            form.answer(value);
            if (byKey) document.getElementById(field)?.focus();
          }}
          onEscape={() => form.answer(null)}
        />
      )}
      <div class="row">
        <button
          type="button"
          class="chip"
          aria-pressed={result === ROUND_MAXIMUM}
          onClick={() => form.type('result', String(ROUND_MAXIMUM))}
        >
          {words.full}
        </button>
        <span class="hint">{result === null ? words.resultHint : understood(result)}</span>
      </div>
    </div>
  );
}

/** The next round and the last wind of the day, to note with one tap. */
function Proposed({ form }: { readonly form: FlightForm }) {
  const { form: words, row } = moreMessages.value.flights;
  const proposed = form.proposed.value;
  if (!proposed) return null;
  const { round, wind } = proposed;
  const facts = [round && roundText(round), wind !== null && row.wind({ wind: measureText(wind) })];
  return (
    <button type="button" class="chip" onClick={() => form.takeProposed()}>
      {words.propose({ facts: dotted(facts) })}
    </button>
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

function Round({ form }: { readonly form: FlightForm }) {
  const { form: words } = moreMessages.value.flights;
  const { round } = form.flight.value;
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
            onClick={() => form.set({ round: round === value ? '' : value })}
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
          onInput={({ currentTarget }) => form.set({ round: currentTarget.value })}
        />
      </span>
    </fieldset>
  );
}

/** A contest round with a short DT for trimming: asks before the flight, says so afterwards. */
function ShortDtNote({ session, log, form, id }: Omit<FormProps, 'onProgram'> & { readonly form: FlightForm }) {
  const { shortDt } = messages.value;
  const { form: words } = moreMessages.value.flights;
  const flight = form.flight.value;
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
        <button type="button" onClick={() => void log.putBack(id)}>
          {shortDt.putBack({ back: whole(dtText(held.back)), remembered: held.remembered })}
        </button>
      )}
    </div>
  );
}

function Where({ session, form }: { readonly session: Session; readonly form: FlightForm }) {
  const { form: words } = moreMessages.value.flights;
  const { label, noModel } = messages.value;
  const { models, flights } = session.library;
  const flight = form.flight.value;
  const places = useId();
  const known = models.get(flight.model);
  const listed = models.list.value.filter(({ model, key }) => !model.archived || key === flight.model);
  return (
    <details>
      <summary>{words.when}</summary>
      <div class="stack gap-3">
        <label class="field">
          <span>{words.date}</span>
          <input
            type="datetime-local"
            aria-invalid={form.problems.value.has('at')}
            value={form.when}
            onChange={({ currentTarget }) => form.setWhen(currentTarget.value)}
          />
        </label>
        <Problem text={form.problems.value.has('at') && words.unreadable['not-a-date']} />
        {flight.utcOffset === undefined && <p class="hint">{words.noOffset}</p>}
        <label class="field">
          <span>{words.place}</span>
          <input
            type="text"
            list={places}
            autocomplete="off"
            maxLength={LIMITS.place}
            value={flight.place}
            onInput={({ currentTarget }) => form.set({ place: currentTarget.value })}
          />
        </label>
        <datalist id={places}>
          {placesOf(flights.list.value).map((place) => (
            <option key={place} value={place} />
          ))}
        </datalist>
        <Choice
          label={label.model}
          choices={[null, ...(flight.model !== null && !known ? [flight.model] : []), ...listed.map(({ key }) => key)]}
          nameOf={(key) => (key === null ? noModel : (models.get(key)?.model.name ?? flight.modelName))}
          chosen={flight.model}
          onChoose={(model) => form.set({ model, modelName: models.get(model)?.model.name ?? '' })}
        />
      </div>
    </details>
  );
}

/** The program that was flown: a copy that nothing changes any more. */
function Flown({ form }: { readonly form: FlightForm }) {
  const { form: words } = moreMessages.value.flights;
  const { program } = form.flight.value;
  return (
    <details>
      <summary>{words.flown}</summary>
      <ProgramGrid program={program} caption={messages.value.program.tableCaption} />
    </details>
  );
}
