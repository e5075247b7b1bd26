import type { Identity } from '../../protocol/index.js';
import type { OpenedSettings } from '../../serial/index.js';
import { media } from '../browser/doors.js';
import { nameplate } from '../browser/services.js';
import { version } from '../browser/version.js';
import { identityText } from '../messages/frame-text.js';
import { messages } from '../messages/index.js';
import type { LineRecord } from '../timer/line-record.js';
import type { Session } from '../work/session.js';
import { captureText } from './recording.js';

/** How many of the last entries go into a report. */
const ENTRIES = 60;

/**
 * What a maintainer needs to know, and nothing about a person: no names, dates or places. It is a capture, with the
 * rest as comments: so it can be replayed.
 */
export function reportText({ log, link, connection }: Pick<Session, 'log' | 'link' | 'connection'>): string {
  const { value: port } = connection;
  const { userAgent, platform } = nameplate();
  const client = port?.client;
  const kept = log.entries.value;
  const found = [...(client?.quirksFound ?? [])].map(([code, params]) =>
    [code, ...pairs(Object.entries(params))].join(' '),
  );
  const counts = Object.entries({ ...log.counts.value, ...(client && { repeats: client.repeats }) });
  const delay = client?.delay ?? null;
  return captureText(log.introduced(kept.slice(-ENTRIES)), [
    programText(),
    `Browser: ${userAgent}, ${platform}`,
    `Page: ${media('(display-mode: standalone)')?.matches ? 'installed' : 'in a browser tab'}`,
    `Port: ${port ? `${port.kind}, ${port.portKey}, ${settingsText(port.settings)}` : 'none'}`,
    `${timerText(client?.identity ?? kept.at(-1)?.layout.identity)}${link.simulated.value ? ', simulated' : ''}`,
    `Found: ${found.join('; ') || 'nothing unusual'}`,
    `Assumed: ${pairs(Object.entries(client?.quirksAssumed ?? {})).join('; ') || 'nothing'}`,
    `Line: ${pairs(counts).join(', ')}`,
    `Line errors: ${pairs([...(client?.lineErrors ?? [])]).join(', ') || 'none'}`,
    `Unasked frames: ${client?.strays ?? 0}; latest reply: ${delay === null ? 'in time' : `after ${Math.round(delay)} ms`}`,
  ]);
}

/** The top of a saved line: what a reader needs to understand it. */
export function captureNotes(records: readonly LineRecord[]): string[] {
  return [programText(), timerText(records.at(-1)?.layout.identity)];
}

function programText(): string {
  return `${messages.value.name} ${version}`;
}

function timerText(identity: Identity | null | undefined): string {
  return `Timer: ${identity ? identityText(identity) : 'not identified'}`;
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
