import type { AssumedQuirks, LineErrorKind, QuirkCode, QuirkParams } from '../../client/index.js';
import type { Identity } from '../../protocol/index.js';
import type { OpenedSettings, PortKind } from '../../serial/index.js';
import { media } from '../browser/doors.js';
import { nameplate } from '../browser/services.js';
import { version } from '../browser/version.js';
import { identityText } from '../messages/frame-text.js';
import { messages } from '../messages/index.js';
import type { LineCounts } from '../session/line-log.js';
import type { LineRecord } from '../session/line-record.js';
import type { Session } from '../session/session.js';
import { captureText } from './recording.js';

/** How many of the last entries go into a report. */
const ENTRIES = 60;

/** What is known about the port. Nothing in it identifies one adapter, or its owner. */
interface PortFacts {
  readonly kind: PortKind;
  /** The name by which settings are remembered, such as `usb:0403:6001`. */
  readonly key: string;
  readonly settings: OpenedSettings;
}

/** What a maintainer needs to know, and nothing about a person: no names, dates or places. */
export interface ReportFacts {
  readonly version: string;
  /** Names and versions of the browser. */
  readonly browser: string;
  readonly platform: string;
  /** Whether the page runs as an installed app. */
  readonly installed: boolean;
  /** Null while no port is open. */
  readonly port: PortFacts | null;
  readonly simulated: boolean;
  readonly identity: Identity | null;
  readonly quirksFound: ReadonlyMap<QuirkCode, QuirkParams>;
  readonly quirksAssumed: AssumedQuirks;
  readonly counts: LineCounts;
  /** Line errors on this connection, by kind. */
  readonly lineErrors: ReadonlyMap<LineErrorKind, number>;
  /** How many requests were repeated on this connection; null without one. */
  readonly repeats: number | null;
  /** How many frames came on this connection that nobody asked for. */
  readonly strays: number;
  /** See `TimerClient.delay`. */
  readonly delay: number | null;
  /** The last entries of the line, oldest first. */
  readonly entries: readonly LineRecord[];
}

/** The report: a capture with everything else as comments, so it can be loaded and replayed as it is. */
export function reportText(facts: ReportFacts): string {
  const { port, identity, counts, repeats, delay } = facts;
  const found = [...facts.quirksFound].map(([code, params]) => [code, ...pairs(Object.entries(params))].join(' '));
  return captureText(facts.entries, [
    programText(facts.version),
    `Browser: ${facts.browser}, ${facts.platform}`,
    `Page: ${facts.installed ? 'installed' : 'in a browser tab'}`,
    `Port: ${port ? `${port.kind}, ${port.key}, ${settingsText(port.settings)}` : 'none'}`,
    `${timerText(identity)}${facts.simulated ? ', simulated' : ''}`,
    `Found: ${found.join('; ') || 'nothing unusual'}`,
    `Assumed: ${pairs(Object.entries(facts.quirksAssumed)).join('; ') || 'nothing'}`,
    `Line: ${pairs([...Object.entries(counts), ...(repeats === null ? [] : [['repeats', repeats] as const])]).join(', ')}`,
    `Line errors: ${pairs([...facts.lineErrors]).join(', ') || 'none'}`,
    `Unasked frames: ${facts.strays}; latest reply: ${delay === null ? 'in time' : `after ${Math.round(delay)} ms`}`,
  ]);
}

/** The top of a saved line: what a reader needs to understand it. */
export function captureNotes(records: readonly LineRecord[]): string[] {
  return [programText(version), timerText(records.at(-1)?.layout.identity ?? null)];
}

function programText(number: string): string {
  return `${messages.value.name} ${number}`;
}

function timerText(identity: Identity | null): string {
  return `Timer: ${identity ? identityText(identity) : 'not identified'}`;
}

/** The facts of this session, the browser and the page. */
export function gatherFacts({ log, link, connection: { value: connection } }: Session): ReportFacts {
  const client = connection?.client;
  const kept = log.entries.value;
  return {
    version,
    ...browserFacts(),
    installed: media('(display-mode: standalone)')?.matches ?? false,
    port: connection && { kind: connection.kind, key: connection.portKey, settings: connection.settings },
    simulated: link.simulated.value,
    identity: client?.identity ?? kept.at(-1)?.layout.identity ?? null,
    quirksFound: client?.quirksFound ?? new Map(),
    quirksAssumed: client?.quirksAssumed ?? {},
    counts: log.counts.value,
    lineErrors: client?.lineErrors ?? new Map(),
    repeats: client?.repeats ?? null,
    strays: client?.strays ?? 0,
    delay: client?.delay ?? null,
    entries: log.introduced(kept.slice(-ENTRIES)),
  };
}

/** What newer Chromium browsers say about themselves, in parts. */
interface UserAgentData {
  readonly brands: readonly { readonly brand: string; readonly version: string }[];
  readonly platform: string;
}

function browserFacts(): Pick<ReportFacts, 'browser' | 'platform'> {
  const { userAgent, platform, userAgentData } = nameplate() as Navigator & { readonly userAgentData?: UserAgentData };
  if (!userAgentData) return { browser: userAgent, platform };
  // The list always has one invented brand, so that pages do not rely on it.
  const brands = userAgentData.brands.filter(({ brand }) => !/not.*brand/i.test(brand));
  return {
    browser: brands.map(({ brand, version: number }) => `${brand} ${number}`).join(', '),
    platform: userAgentData.platform,
  };
}

/** `9600 8N1, DTR low`: names a line only where it is not left to the browser. */
function settingsText({ baudRate, dataBits, parity, stopBits, dtr, rts }: OpenedSettings): string {
  const form = `${baudRate} ${dataBits}${parity.charAt(0).toUpperCase()}${stopBits}`;
  const lines = Object.entries({ DTR: dtr, RTS: rts }).filter(([, level]) => level !== null);
  return [form, ...lines.map(([name, level]) => `${name} ${level ? 'high' : 'low'}`)].join(', ');
}

function pairs(values: readonly (readonly [string, unknown])[]): string[] {
  return values.map(([name, value]) => `${name} ${value}`);
}
