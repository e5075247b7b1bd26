import type { TimerProgram } from '../../program/index.js';
import { dotted } from '../messages/dotted.js';
import { dtText, messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import type { FlightRecord } from '../storage/index.js';
import { memo } from '../ui/memo.js';
import type { ShortDt } from '../work/short-dt.js';
import type { FlightLog } from './flight-log.js';
import { changedText, clockOf, dayHeading, resultText, roundText } from './flight-text.js';
import { measureText } from './measures.js';
import { scoreOf } from './score.js';
import { ScoreCard } from './score-card.js';
import './flight-rows.css';

interface FlightRowsProps {
  /** By day and place. */
  readonly days: ReadonlyMap<string, readonly FlightRecord[]>;
  /** What the model of each flight flew before it, by the key of the flight. */
  readonly before: ReadonlyMap<string, TimerProgram>;
  readonly shortDt: ShortDt;
  readonly log: FlightLog;
}

/** The flights by day and place. The browser skips the drawing of those far from the window. */
export function FlightRows({ days, before, ...props }: FlightRowsProps) {
  const { totals, score: words } = moreMessages.value.flights;
  const { log } = props;
  const { day, of } = log.filter.value;
  return (
    <div class="stack">
      {[...days].map(([key, records]) => {
        const { flight: latest } = records[0] as FlightRecord;
        const title = dotted([dayHeading(latest), latest.place]);
        const isOpen = day === key;
        return (
          <section class="flight-day" key={key} aria-label={title}>
            <div class="row">
              <h2>
                <span>{title}</span> {/* Of a single day, the totals above say the same. */}
                {days.size > 1 && <small>{totals.flights({ count: records.length })}</small>}
              </h2>
              {(isOpen || records.some(({ flight }) => flight.round.trim() !== '')) && (
                <button
                  type="button"
                  class="chip"
                  aria-pressed={isOpen}
                  // Of one model, but not of one program: a part of its flights would have a wrong total.
                  onClick={() => log.showOnly({ of: of?.kind === 'model' ? of : null, day: isOpen ? null : key })}
                >
                  {words.open}
                </button>
              )}
            </div>
            {isOpen && <ScoreCard score={scoreOf(records.map(({ flight }) => flight))} log={log} />}
            <ul class="ruled">
              {records.map((record) => (
                <Row key={record.key} record={record} before={before.get(record.key)} {...props} />
              ))}
            </ul>
          </section>
        );
      })}
    </div>
  );
}

interface RowProps extends Pick<FlightRowsProps, 'shortDt' | 'log'> {
  readonly record: FlightRecord;
  readonly before: TimerProgram | undefined;
}

/** Only a flight that changes is drawn again: a season is long, and its programs are compared. */
const Row = memo(RowContent);

function RowContent({ record: { key, flight }, before, shortDt, log }: RowProps) {
  const { row: words } = moreMessages.value.flights;
  const { wind, temperature, round, result, note, program } = flight;
  const facts = [
    round === '' ? null : roundText(round),
    wind === null ? null : words.wind({ wind: measureText(wind) }),
    temperature === null ? null : words.temperature({ degrees: measureText(temperature).replace('-', '−') }),
    before && changedText(before, program),
    note.split('\n')[0] || null,
  ];
  return (
    <li>
      <button type="button" class="flight-row" onClick={() => log.fillIn(key)}>
        <span class="flight-time">{clockOf(flight)}</span>
        <span class="flight-what">
          <b>{flight.modelName || messages.value.noModel}</b>
          {flight.settingName && `\u00a0· ${flight.settingName}`}
        </span>
        {facts.some(Boolean) && <small class="flight-facts">{dotted(facts)}</small>}
        <span class="flight-end">
          {result === null ? <small>{words.noResult}</small> : <b>{resultText(result)}</b>}
          {shortDt.isShort(program) && (
            <small class="bad-text">
              {messages.value.program.dt} {dtText(program.times[program.identity.functions] as number)}
            </small>
          )}
        </span>
      </button>
    </li>
  );
}
