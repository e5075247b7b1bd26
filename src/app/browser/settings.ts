import * as v from 'valibot';
import { service } from './services.js';

/** Small choices that the browser keeps. Where it keeps nothing, they last as long as the page. */
const PREFIX = 'sidus-timer/';

/** @returns null when nothing is kept under this name, or a value of another form. */
export function loadSetting<T>(name: string, schema: v.GenericSchema<unknown, T>): T | null {
  try {
    const text = service('localStorage')?.getItem(PREFIX + name) ?? null;
    const parsed = v.safeParse(schema, text === null ? null : JSON.parse(text));
    return parsed.success ? parsed.output : null;
  } catch {
    return null;
  }
}

export function saveSetting(name: string, value: unknown): void {
  try {
    service('localStorage')?.setItem(PREFIX + name, JSON.stringify(value));
  } catch {
    // The storage is full or switched off: the choice lasts as long as this page.
  }
}

/** Whether the browser keeps such choices at all. It may have the storage and still refuse. */
export function keepsSettings(): boolean {
  try {
    const kept = service('localStorage');
    kept?.setItem(`${PREFIX}probe`, '1');
    kept?.removeItem(`${PREFIX}probe`);
    return kept !== null;
  } catch {
    return false;
  }
}

/**
 * Forgets all of them.
 * @throws the error of the browser when it refuses its storage.
 */
export function eraseSettings(): void {
  const kept = service('localStorage');
  if (!kept) throw new Error('no localStorage');
  const names = Array.from({ length: kept.length }, (_, index) => kept.key(index));
  for (const name of names) if (name?.startsWith(PREFIX)) kept.removeItem(name);
}
