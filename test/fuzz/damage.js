// What happens to files and links on their way, and what a joker does to them.

import fc from 'fast-check';

/** Parts of texts that want to do harm, or are something else. */
const HOSTILE = [
  ...['{', '}', '[', ']', '"', ',', ':', '\\', '\\u', '\\ud800', '\u0000', '\ufeff', '\u2028', '/*', '//', "'", '`'],
  ...['null', 'true', 'NaN', 'Infinity', '-0', '1e999', '-1', '0.1', '1E-7', '00', '65536', '9007199254740993', '"M0"'],
  ...['{"__proto__":{"polluted":1}}', '"constructor"', '{"constructor":{"prototype":{"polluted":1}}}', '"toString"'],
  ...['[['.repeat(60), '{"a":'.repeat(60), '[]', '{}', '""', '"655.36"', '"1.5"', '"2026-02-30T00:00:00.000Z"'],
];

const place = fc.double({ min: 0, max: 1, noNaN: true });

const step = fc.record({
  kind: fc.constantFrom('cut', 'drop', 'repeat', 'swap', 'insert', 'replace', 'flip', 'from the front'),
  at: place,
  to: place,
  count: fc.integer({ min: 1, max: 12 }),
  bit: fc.integer({ min: 0, max: 6 }),
  hostile: fc.constantFrom(...HOSTILE),
});

/** One to three faults of a text. @returns {(text: string) => string} */
export const textDamage = fc.array(step, { minLength: 1, maxLength: 3 }).map((steps) => {
  const damage = (/** @type {string} */ text) => steps.reduce(damaged, text);
  return Object.assign(damage, { toString: () => JSON.stringify(steps) });
});

/** @param {string} text @param {fc.GeneratorValue extends never ? never : any} step */
function damaged(text, { kind, at, to, count, bit, hostile }) {
  const from = Math.floor(at * text.length);
  const other = Math.floor(to * text.length);
  const end = Math.min(from + count, text.length);
  switch (kind) {
    case 'cut':
      return text.slice(0, from);
    case 'from the front':
      return text.slice(end);
    case 'drop':
      return text.slice(0, from) + text.slice(end);
    case 'repeat':
      return text.slice(0, end) + text.slice(from);
    case 'swap': {
      const [first = 0, second = 0] = [from, other].sort((a, b) => a - b);
      const length = Math.min(count, second - first, text.length - second);
      const [one, two] = [text.slice(first, first + length), text.slice(second, second + length)];
      return text.slice(0, first) + two + text.slice(first + length, second) + one + text.slice(second + length);
    }
    case 'flip': {
      const code = text.charCodeAt(from) ^ (1 << bit);
      return text.slice(0, from) + (from < text.length ? String.fromCharCode(code) : '') + text.slice(from + 1);
    }
    case 'insert':
      return text.slice(0, from) + hostile + text.slice(from);
    default:
      return text.slice(0, from) + hostile + text.slice(end);
  }
}

/** Values that a field may be given, most of them wrong. */
const odd = fc.oneof(
  fc.constantFrom(null, true, '', 'x', 'M1', 'M999', 'Q', 'B', 'DT', '1', '1.00', '655.36', 'a'.repeat(61), 0, 1, -1),
  fc.constantFrom(1.5, 126, 131, 255, 256, 1e300, [], {}, '2026-01-01T00:00:00.000Z', '2026-13-01T00:00:00.000Z'),
  fc.constantFrom('start', 'rudder', 'timer', '__proto__', '2026-02-30T00:00:00.000Z', '+300000-01-01T00:00:00.000Z'),
  fc.jsonValue({ maxDepth: 2 }),
);

const change = fc.record({
  kind: fc.constantFrom('delete', 'set', 'copy', 'rename', 'add', 'swap'),
  at: fc.nat(),
  to: fc.nat(),
  value: odd,
});

/** One to three changes of the values in a JSON text, which stays JSON. @returns {(value: unknown) => unknown} */
export const valueDamage = fc.array(change, { minLength: 1, maxLength: 3 }).map((changes) => {
  const damage = (/** @type {any} */ value) => {
    const copy = structuredClone(value);
    for (const each of changes) alter(copy, each);
    return copy;
  };
  return Object.assign(damage, { toString: () => JSON.stringify(changes) });
});

/** All places of a value: what they stand in, and under which name. @param {any} value @returns {[any, any][]} */
function placesOf(value) {
  if (typeof value !== 'object' || value === null) return [];
  const names = Array.isArray(value) ? [...value.keys()] : Object.keys(value);
  return names.flatMap((name) => [/** @type {[any, any]} */ ([value, name]), ...placesOf(value[name])]);
}

/** @param {any} root @param {{ kind: string, at: number, to: number, value: unknown }} change */
function alter(root, { kind, at, to, value }) {
  const places = placesOf(root);
  const [holder, name] = places[at % Math.max(1, places.length)] ?? [root, 'x'];
  const [other, otherName] = places[to % Math.max(1, places.length)] ?? [root, 'x'];
  const own = structuredClone(holder[name]);
  const put = (/** @type {any} */ into, /** @type {any} */ as, /** @type {any} */ what) =>
    Object.defineProperty(into, as, { value: what, enumerable: true, configurable: true, writable: true });
  if (kind === 'set') put(holder, name, value);
  else if (kind === 'add') put(holder, Array.isArray(holder) ? holder.length : `more ${to % 9}`, value);
  else if (kind === 'copy') put(holder, Array.isArray(holder) ? holder.length : '__proto__', own);
  else if (kind === 'swap') {
    const theirs = structuredClone(other[otherName]);
    put(holder, name, theirs);
    // The other place may have gone with what has just been replaced; then the change has no effect.
    put(other, otherName, own);
  } else {
    if (Array.isArray(holder)) holder.splice(name, 1);
    else delete holder[name];
    if (kind === 'rename' && !Array.isArray(holder)) put(holder, otherName, own);
  }
}

/** Any JSON, and what is none. */
export const hostileText = fc.oneof(
  fc.json({ maxDepth: 4 }),
  fc.string({ maxLength: 40 }),
  fc.constantFrom(...HOSTILE),
  fc.array(fc.constantFrom(...HOSTILE), { minLength: 1, maxLength: 8 }).map((parts) => parts.join('')),
  fc
    .tuple(fc.integer({ min: 1, max: 100_000 }), fc.constantFrom('[', '{"a":', '{"models":[', '[[],'))
    .map(([count, part]) => part.repeat(count)),
);
