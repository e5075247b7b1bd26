/** How a port is opened. */
export interface SerialSettings {
  /** Bits a second, or `find`: the link tries 9600, 19200, 38400, 57600, 115200 and 4800 until the timer answers. */
  readonly baudRate: number | 'find';
  /** Bits in a byte. Timers use 8. */
  readonly dataBits: 7 | 8;
  /** Timers use none. */
  readonly parity: 'none' | 'even' | 'odd';
  /** Stop bits after each byte. Timers use 1. */
  readonly stopBits: 1 | 2;
  /** The DTR line: true raised, false dropped, null as the browser leaves it (raised). */
  readonly dtr: boolean | null;
  /** The RTS line: true raised, false dropped, null as the browser leaves it. */
  readonly rts: boolean | null;
}

/** Settings with a fixed rate. */
export type OpenedSettings = SerialSettings & { readonly baudRate: number };

/** The link finds the rate. 8 data bits, no parity, 1 stop bit: see docs/protocol.md on the speed of the line. */
export const DEFAULT_SETTINGS: SerialSettings = Object.freeze({
  baudRate: 'find',
  dataBits: 8,
  parity: 'none',
  stopBits: 1,
  dtr: null,
  rts: null,
});

/** Rates in the order in which they are tried. Never empty. */
export type Rates = readonly [number, ...number[]];

/**
 * The rates at which a timer may answer, in bits a second, the likeliest first: 9600, 19200, 38400, 57600, 115200,
 * 4800. The recording of a real one rules out 2400 and below.
 */
export const RATES: Rates = Object.freeze([9600, 19200, 38400, 57600, 115200, 4800]) as Rates;

/**
 * The rates to try on a port, the likeliest first: the one known to have worked there, then {@link RATES}. Only one
 * rate if the settings name it, or over Bluetooth, where the rate has no meaning.
 */
export function ratesToTry({ baudRate }: SerialSettings, isBluetooth: boolean, knownRate?: number): Rates {
  if (baudRate !== 'find') return [baudRate];
  const [first, ...others] =
    knownRate === undefined ? RATES : [knownRate, ...RATES.filter((rate) => rate !== knownRate)];
  return isBluetooth ? [first] : [first, ...others];
}

/** One in this many quiet questions uses another rate than the likeliest. */
const OTHER_RATE_EVERY = 4;

/**
 * How many questions in a row use one rate, once every rate was asked. Another rate needs another opening, and some
 * adapters restart then (DTR resets them) and are deaf for up to three seconds. At one question a second, such an
 * adapter hears the last one.
 */
const STAY = 5;

/**
 * The rate of quiet question number `asked`, counted from 0. At first three of four questions use the likeliest rate,
 * the fourth uses the next of the others. So after 4 questions for each other rate, every rate was asked: at one
 * question a second, within 24 seconds. From then on the port stays open for {@link STAY} questions: at the likeliest
 * rate, at the first of the others, at the likeliest again, at the second of the others ...
 */
export function quietRate([likeliest, ...others]: Rates, asked: number): number {
  const quick = OTHER_RATE_EVERY * others.length;
  if (asked >= quick) {
    const stay = Math.floor((asked - quick) / STAY);
    return (stay % 2 === 1 && others[((stay - 1) / 2) % others.length]) || likeliest;
  }
  const round = Math.floor(asked / OTHER_RATE_EVERY);
  const isOthersTurn = asked % OTHER_RATE_EVERY === OTHER_RATE_EVERY - 1;
  return (isOthersTurn && others[round % others.length]) || likeliest;
}
