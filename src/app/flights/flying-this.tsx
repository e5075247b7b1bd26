import { useEffect } from 'preact/hooks';
import { dotted } from '../messages/dotted.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { useHandedFocus } from '../ui/use-handed-focus.js';
import type { Session } from '../work/session.js';
import { timeOfDay } from './flight-list.js';
import type { FlightLog } from './flight-log.js';
import { heldText } from './flight-text.js';
import './flying-this.css';

export interface FlyingThisProps {
  readonly session: Session;
  readonly log: FlightLog;
  /** The form of the flight is about to open. */
  readonly onFillIn?: () => void;
  /** For the log of flights: it shows what would be logged, and logs the last flight again without a timer. */
  readonly again?: boolean;
}

/** How long the note about a logged flight stands in the place of the button, in milliseconds. */
const NOTE_STAYS = 60_000;

/** One tap logs a flight with what the timer holds. Then it says so, and offers to undo it or to fill it in. */
export function FlyingThis({ session, log, onFillIn, again = false }: FlyingThisProps) {
  const { flying: words } = moreMessages.value.flights;
  const { noModel, undo } = messages.value;
  const { flights } = session.library;
  const key = log.logged.value;
  const logged = flights.get(key)?.flight;
  const held = log.flyable.value;
  const box = useHandedFocus('button:not(.quiet)');
  // The note about a logged flight goes away with this part of the page, and in time for the next flight. Not behind
  // the form: what has opened it gets the focus back.
  const isFilling = log.filling.value !== null;
  useEffect(() => {
    const rest = isFilling ? undefined : setTimeout(() => log.forgetLogged(), NOTE_STAYS);
    return () => clearTimeout(rest);
  }, [log, key, isFilling]);
  useEffect(() => () => log.forgetLogged(), [log]);
  if (logged) {
    const fillIn = (): void => {
      // A dialog around this closes first, so that the form gives the focus back to where that one was opened.
      onFillIn?.();
      log.fillIn(logged.id);
    };
    return (
      <div class="row between flying-this" {...box}>
        <p role="status">
          <strong>
            {dotted([words.logged({ time: timeOfDay(logged) }), logged.modelName || noModel, logged.place])}
          </strong>
        </p>
        <div class="buttons">
          <button type="button" class="quiet" onClick={() => log.remove(logged.id)}>
            {undo}
          </button>
          <button type="button" onClick={fillIn}>
            {words.fillIn}
          </button>
        </div>
      </div>
    );
  }
  const last = again ? flights.list.value[0]?.flight : undefined;
  const offer = held
    ? // After a write, the figures stand above.
      { text: again ? heldText(held) : words.purpose, name: words.button, log: () => log.flying() }
    : last && {
        text: dotted([last.modelName || noModel, last.settingName, heldText(last.program)]),
        name: words.again,
        log: () => log.flyAgain(last),
      };
  if (!offer) return null;
  return (
    <div class="row between flying-this" {...box}>
      <p class="hint">{offer.text}</p>
      <button type="button" class={again ? 'primary' : undefined} onClick={offer.log}>
        {offer.name}
      </button>
    </div>
  );
}
