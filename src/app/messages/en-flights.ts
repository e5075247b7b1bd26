import { en } from './en.js';
import { libraryMessages } from './en-library.js';
import { plural } from './plural.js';

/** The log of flights. It loads these sentences with itself. */
export const flightMessages = {
  title: 'Flights',
  empty: {
    title: 'No flight logged yet.',
    advice: 'Read or write a timer, then press “Flying this”.',
  },
  failed: libraryMessages.unread,
  nothingFound: 'No flight fits this filter.',
  flying: {
    /** One tap logs a flight with what the timer holds. */
    button: 'Flying this',
    purpose: 'Logs a flight with what the timer holds.',
    logged: (time: string) => `Flight logged ${time}`,
    fillIn: 'Fill in',
    again: 'Fly this again',
  },
  row: {
    round: (round: string) =>
      /^\d/.test(round) ? `Round ${round}` : `${round.charAt(0).toUpperCase()}${round.slice(1)}`,
    wind: (wind: string) => `${wind}\u00a0m/s`,
    temperature: (degrees: string) => `${degrees.replace('-', '−')}\u00a0°C`,
    noResult: 'no result',
    /** Since the flight of the same model before. @param values such as “3 values”. */
    changed: (values: string) => `${values} changed`,
    otherTimer: 'another timer',
  },
  totals: {
    flights: (count: number) => plural(count, 'flight', 'flights'),
    best: (time: string) => `best ${time}`,
    average: (time: string) => `average ${time}`,
  },
  filter: {
    period: 'Period',
    periods: { all: 'Any time', today: 'Today', year: 'This year' },
    /** @param name of a model or a saved program. */
    of: (name: string) => `Flights of ${name}`,
    clear: 'Show all',
  },
  form: {
    title: 'Flight',
    result: 'Result',
    resultHint: 'Seconds, or minutes like 2:58.',
    readAs: (time: string, seconds: string) => `${time}, ${seconds} s`,
    /** @param facts the next round and the last wind. */
    propose: (facts: string) => `Note ${facts}`,
    full: 'Full round, 180 s',
    round: 'Round',
    flyOff: 'Fly-off',
    wind: 'Wind',
    windUnit: 'm/s',
    temperature: 'Temperature',
    temperatureUnit: '°C',
    when: 'Date, place, model',
    date: 'Date and time',
    noOffset: 'The time zone of the field is not known: this is the time of this device.',
    place: 'Place',
    flown: 'What was flown',
    open: 'Open its program',
    unreadable: {
      ambiguous: 'Say what it means.',
      'not-a-number': 'Not a number.',
      'not-a-time': 'Not a time: type seconds like 178, or minutes like 2:58.',
      'too-fine': en.unreadable['too-fine'],
      'not-a-date': 'Not a date.',
    },
    range: (min: number, max: number, unit: string) => `${min} to ${max} ${unit}.`,
    shortDt: (dt: string) => `DT was ${dt} on this flight.`,
  },
  score: {
    open: 'Score card',
    /** The maximum of the day. */
    maximum: 'Maximum of each round',
    none: 'Without a maximum each result counts in full.',
    /** @param round such as “Round 3”. */
    maximumOf: (round: string) => `Maximum of ${round}`,
    counted: 'Counted (s)',
    notCounted: 'not counted',
    count: 'Count this',
    noRound: 'no round',
    total: 'Total',
    copy: 'Copy as text',
  },
  csv: {
    save: 'Save as a table (CSV)',
    columns: {
      date: 'Date',
      time: en.program.time,
      zone: 'Time zone',
      place: 'Place',
      model: en.label.model,
      setting: 'Program',
      timerClass: 'Timer class',
      memory: en.program.memory,
      dt: 'DT (s)',
      motorStop: 'Motor stop (s)',
      wind: 'Wind (m/s)',
      temperature: 'Temperature (°C)',
      round: 'Round',
      result: 'Result (s)',
      maximum: 'Maximum (s)',
      note: en.label.note,
    },
  },
  /** On the page of a model or a saved program. */
  section: { all: 'All its flights' },
};
