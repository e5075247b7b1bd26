import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import { dotted } from '../messages/dotted.js';
import { flightMessages } from '../messages/en-flights.js';
import { dtText } from '../messages/index.js';
import type { ShortDt } from '../session/short-dt.js';
import type { FlightRecord } from '../storage/index.js';
import { type FlightDay, isRound } from './flight-list.js';
import { clockOf, dayHeading, isFull, resultText } from './flight-text.js';
import { measureText } from './measures.js';
import './flight-rows.css';

interface FlightRowsProps {
  readonly days: readonly FlightDay[];
  readonly shortDt: ShortDt;
  readonly onOpen: (key: string) => void;
}

/** How many rows appear and disappear together. */
const CHUNK = 40;
/** Approximate heights of a row and a heading, in rem, before they are first drawn. */
const ABOUT = { row: 4, head: 3.4 };

/** A part of a day, at most one chunk long. */
interface Part extends FlightDay {
  /** Whether it continues a day. */
  readonly goesOn: boolean;
  /** How many flights the whole day has. */
  readonly count: number;
}

/**
 * The flights by day and place. Of ten thousand, only those near the window are in the page;
 * the others keep their space.
 */
export function FlightRows({ days, ...props }: FlightRowsProps) {
  // Of a single day, the totals above say the same.
  const counted = days.length > 1;
  return (
    <div class="flight-days">
      {chunksOf(days).map((parts, at) => (
        <Near
          key={parts[0]?.records[0]?.key}
          begin={at === 0}
          about={parts.reduce(
            (sum, { goesOn, records }) => sum + (goesOn ? 0 : ABOUT.head) + records.length * ABOUT.row,
            0,
          )}
        >
          {() =>
            parts.map((part) => <Day key={`${part.key} ${part.records[0]?.key}`} {...{ part, counted }} {...props} />)
          }
        </Near>
      ))}
    </div>
  );
}

/** The days in order, cut into chunks. */
function chunksOf(days: readonly FlightDay[]): readonly (readonly Part[])[] {
  const chunks: Part[][] = [[]];
  let room = CHUNK;
  for (const day of days) {
    for (let from = 0; from < day.records.length; ) {
      if (room === 0) {
        chunks.push([]);
        room = CHUNK;
      }
      const records = day.records.slice(from, from + room);
      chunks.at(-1)?.push({ ...day, records, goesOn: from > 0, count: day.records.length });
      room -= records.length;
      from += records.length;
    }
  }
  return chunks;
}

interface NearProps {
  /** Whether it is drawn at once. */
  readonly begin: boolean;
  /** Its approximate height, in rem. */
  readonly about: number;
  readonly children: () => ComponentChildren;
}

/** Draws its content only while it is near the window. */
function Near({ begin, about, children }: NearProps) {
  const box = useRef<HTMLDivElement>(null);
  const [isNear, setNear] = useState(begin);
  /** Its height when it was last drawn. */
  const [height, setHeight] = useState<number | null>(null);
  useEffect(() => {
    const { current: element } = box;
    if (!element) return;
    const observer = new IntersectionObserver(
      ([entry]) => {
        if (!entry) return;
        // Content with the keyboard focus stays.
        if (!entry.isIntersecting && element.contains(document.activeElement)) return;
        if (!entry.isIntersecting && entry.boundingClientRect.height > 0) setHeight(entry.boundingClientRect.height);
        setNear(entry.isIntersecting);
      },
      { rootMargin: '1200px 0px' },
    );
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return (
    <div ref={box} style={isNear ? undefined : { height: height === null ? `${about}rem` : `${height}px` }}>
      {isNear && children()}
    </div>
  );
}

interface DayProps extends Omit<FlightRowsProps, 'days'> {
  readonly part: Part;
  /** Whether to say how many flights the day has. */
  readonly counted: boolean;
}

function Day({ part, counted, ...props }: DayProps) {
  const words = flightMessages;
  const { latest, place, goesOn, count, records } = part;
  const title = words.day(dayHeading(latest), place);
  return (
    <section class="flight-day" aria-label={title}>
      {!goesOn && (
        <h2>
          <span>{title}</span> {counted && <span class="flight-count">{words.dayCount(count)}</span>}
        </h2>
      )}
      <ul>
        {records.map((record) => (
          <Row key={record.key} record={record} {...props} />
        ))}
      </ul>
    </section>
  );
}

interface RowProps extends Omit<FlightRowsProps, 'days'> {
  readonly record: FlightRecord;
  /** The list stands under a model or a setting, not under days. */
  readonly of?: 'model' | 'setting';
}

export function Row({ record: { key, flight }, shortDt, onOpen, of }: RowProps) {
  const { row: words } = flightMessages;
  const { wind, temperature, round, result, note, program } = flight;
  const day = of && flightMessages.day(dayHeading(flight), flight.place);
  // A name that all rows share stands above them.
  const name = of === 'setting' ? '' : of === 'model' ? flight.settingName : flight.modelName || words.noModel;
  const facts = [
    (name && day) || null,
    round === '' ? null : words.round(round),
    wind === null ? null : words.wind(measureText(wind)),
    temperature === null ? null : words.temperature(measureText(temperature)),
    note.split('\n')[0] || null,
  ];
  return (
    <li>
      <button type="button" class="flight-row" onClick={() => onOpen(key)}>
        <span class="flight-time">{clockOf(flight)}</span>
        <span class="flight-what">
          <b>{name || day}</b>
          {!of && flight.settingName && `\u00a0· ${flight.settingName}`}
        </span>
        {facts.some(Boolean) && <small class="flight-facts">{dotted(facts)}</small>}
        <span class="flight-end">
          {result === null ? (
            <small>{words.noResult}</small>
          ) : (
            <b class={isRound(flight) && isFull(flight) ? 'full' : undefined}>{resultText(result)}</b>
          )}
          {shortDt.isShort(program) && (
            <small class="bad-text">{words.dt(dtText(program.times[program.identity.functions] as number))}</small>
          )}
        </span>
      </button>
    </li>
  );
}
