import type { Flight } from '../../program/index.js';
import { dotted } from '../messages/dotted.js';
import { moreMessages } from '../messages/more.js';
import { CopyButton } from '../ui/copy-button.js';
import { useHandedFocus } from '../ui/use-handed-focus.js';
import type { FlightLog, FlightScore } from './flight-log.js';
import { clockOf, resultText, roundText } from './flight-text.js';
import { MaximumField } from './maximum-field.js';
import { measureText } from './measures.js';
import type { Score, ScoreLine } from './score.js';
import { pointsText, scoreText } from './score-text.js';
import './score-card.css';

/** The flights of a day and place as a contestant writes them down. */
export function ScoreCard({ score, log }: { readonly score: Score; readonly log: FlightLog }) {
  const { score: words, csv } = moreMessages.value.flights;
  const { rounds, others, maximum, total, models } = score;
  const box = useHandedFocus('.copy-button button');
  const say = (flights: readonly Flight[], change: (flight: Flight) => Omit<FlightScore, 'id'>): void =>
    void log.score(flights.map((flight) => ({ id: flight.id, ...change(flight) })));
  const rowOf = (line: ScoreLine, ofDay: number | null) => {
    const { flight, round, counts, own, points } = line;
    const name = roundText(flight.round.trim()) || words.noRound;
    return (
      <tr key={flight.id}>
        <th scope="row">
          {rounds.includes(line) ? flight.round : name}{' '}
          <small>{dotted([round.length > 1 && clockOf(flight), models.length > 1 && flight.modelName])}</small>
        </th>
        <td>{measureText(flight.result)}</td>
        <td>
          {counts && (
            <MaximumField
              label={words.maximumOf({ round: name })}
              value={own}
              otherwise={ofDay}
              onTake={(value) => say(round, () => ({ maximum: value }))}
            />
          )}
        </td>
        <td>
          {points === null ? <small>{pointsText(line)}</small> : <b>{pointsText(line)}</b>}
          {points === null && flight.result !== null && name !== words.noRound && (
            <button
              type="button"
              class="quiet"
              onClick={() => say(round, (each) => ({ counts: each === flight || null }))}
            >
              {words.count}
            </button>
          )}
        </td>
      </tr>
    );
  };
  return (
    <div class="stack panel score-card" {...box}>
      {models.length > 0 && <p>{models.join(', ')}</p>}
      {rounds.length > 0 && (
        <div class="field">
          <span>{words.maximum}</span>
          <MaximumField
            label={words.maximum}
            value={maximum}
            // A round with another one keeps that.
            onTake={(value) =>
              say(
                rounds.flatMap(({ flight, own }) => (own === null || own === maximum ? flight : [])),
                () => ({ maximum: value }),
              )
            }
          />
          {maximum === null && <small>{words.none}</small>}
        </div>
      )}
      <table class="value-grid">
        <caption class="visually-hidden">{words.open}</caption>
        <thead>
          <tr>
            {[csv.columns.round, csv.columns.result, csv.columns.maximum, words.counted].map((head) => (
              <th scope="col" key={head}>
                {head}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rounds.map((line) => rowOf(line, maximum))}
          {rounds.length > 0 && (
            <tr class="score-total">
              <th scope="row">{words.total}</th>
              <td colSpan={3}>
                <small>{resultText(total)}</small> <b>{measureText(total)}</b>
              </td>
            </tr>
          )}
          {others.map((line) => rowOf(line, null))}
        </tbody>
      </table>
      <div class="buttons">
        <CopyButton label={words.copy} text={() => scoreText(score)} />
      </div>
    </div>
  );
}
