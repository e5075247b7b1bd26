interface Stored {
  readonly [name: string]: unknown;
  readonly kind?: unknown;
  readonly column?: unknown;
}

/**
 * A stored record with the present names. Until version 4 of the storage a program had `timers`, the name of a step a
 * `column`, and a memory round trip a `home`. Anything else stays as it is; the schemas check it.
 */
export function withPresentNames(stored: unknown): unknown {
  if (Array.isArray(stored)) return stored.map(withPresentNames);
  if (typeof stored !== 'object' || stored === null) return stored;
  const record = stored as Stored;
  return Object.fromEntries(
    Object.entries(record).map(([name, value]) => [presentName(name, record), withPresentNames(value)]),
  );
}

function presentName(name: string, record: Stored): string {
  if (name === 'timers' && 'positions' in record) return 'times';
  if (name === 'home' && record.kind === 'memories') return 'original';
  // Only the parameters of a step have it: as a number, beside the rest of its name.
  return name === 'column' && typeof record.column === 'number' ? 'slot' : name;
}
