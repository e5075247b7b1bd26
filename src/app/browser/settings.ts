import * as v from 'valibot';
import { service } from './services.js';

/** Small choices that the browser keeps. Where it keeps nothing, they last as long as the page. */
const PREFIX = 'sidus-timer/';

/** For all tabs and for good; or for one tab until it is closed. */
const PLACES = ['localStorage', 'sessionStorage'] as const;
type Place = (typeof PLACES)[number];

/** @returns null when nothing is kept under this name, or a value of another form. */
export function loadSetting<T>(
  name: string,
  schema: v.GenericSchema<unknown, T>,
  place: Place = 'localStorage',
): T | null {
  try {
    const text = service(place)?.getItem(PREFIX + name) ?? null;
    const parsed = v.safeParse(schema, text === null ? null : JSON.parse(text));
    return parsed.success ? parsed.output : null;
  } catch {
    return null;
  }
}

export function saveSetting(name: string, value: unknown, place: Place = 'localStorage'): void {
  try {
    service(place)?.setItem(PREFIX + name, JSON.stringify(value));
  } catch {
    // The storage is full or switched off: the choice lasts as long as this page.
  }
}

/** Whether the browser keeps such choices at all. It may have the storage and still refuse. */
export function keepsSettings(): boolean {
  try {
    for (const place of PLACES) {
      const kept = service(place);
      if (!kept) return false;
      kept.setItem(`${PREFIX}probe`, '1');
      kept.removeItem(`${PREFIX}probe`);
    }
    return true;
  } catch {
    return false;
  }
}

/**
 * Forgets all of them.
 * @throws the error of the browser when it refuses its storage.
 */
export function eraseSettings(): void {
  for (const place of PLACES) {
    const kept = service(place);
    if (!kept) throw new Error(`no ${place}`);
    const names = Array.from({ length: kept.length }, (_, index) => kept.key(index));
    for (const name of names) if (name?.startsWith(PREFIX)) kept.removeItem(name);
  }
}
