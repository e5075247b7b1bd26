// What holds for files and links whatever comes: each law as a property of the package that is handed in.

import { readFileSync } from 'node:fs';
import { crc32 } from 'node:zlib';
import fc from 'fast-check';
import { breach } from '../program/json-schema.js';
import { hostileText, textDamage, valueDamage } from './damage.js';
import { flight, library, model, program, setting, shared, words } from './kept.js';
import { hold } from './laws.js';

/**
 * @typedef {Pick<typeof import('../../src/program/index.js'), 'decodeLink' | 'encodeLink' | 'formatLibraryFile' |
 *   'parseLibraryFile' | 'requireLibrary'> & Pick<typeof import('../../src/protocol/index.js'), 'CodecError'>} Keeping
 */

const schema = JSON.parse(readFileSync(new URL('../../public/library.schema.json', import.meta.url), 'utf8'));

/** What a schema cannot see: two values that do not fit together, a day that no month has, a name twice in the text. */
const BEYOND_SCHEMA = [
  /^(wrong-count|duplicate|bad-identity) /,
  /^unknown-word .*\.(slot|memory)$/,
  /^wrong-type .*(At|\.at|\.until)$/,
  // Above the other end of the servo.
  /^out-of-range .*\.low$/,
];

/** Equal, down to the names. @param {unknown} one @param {unknown} other */
function same(one, other) {
  hold(JSON.stringify(one) === JSON.stringify(other), `${JSON.stringify(other)}\n  should be ${JSON.stringify(one)}`);
}

/** A library with one of each, and a second of some. */
const some = fc.oneof(
  library,
  fc.record({ models: fc.tuple(model), settings: fc.tuple(setting), flights: fc.tuple(flight) }),
);
const date = fc.integer({ min: 0, max: 4_000_000_000_000 });
const head = fc.record({ writtenAt: date, writtenBy: words(200) });
/** @typedef {import('../../src/program/index.js').EntryFacts} EntryFacts */
/** @type {fc.Arbitrary<EntryFacts>} */
const facts = fc.record(
  {
    verified: fc.array(
      fc.record(
        { at: date, program, simulated: fc.boolean() },
        { requiredKeys: ['at', 'program'], noNullPrototype: true },
      ),
      { maxLength: 2 },
    ),
    versions: fc.array(
      fc.record(
        { until: date, at: date, program, from: fc.constantFrom(.../** @type {const} */ (['typed', 'timer', 'link'])) },
        { noNullPrototype: true },
      ),
      { maxLength: 2 },
    ),
    changedAt: date,
  },
  { requiredKeys: [], noNullPrototype: true },
);

/**
 * What is known of the entries of a library: of each kind what its entries may have.
 * @param {import('../../src/program/index.js').Library} of @param {readonly EntryFacts[]} known
 */
function factsOf({ models, settings, flights }, known) {
  /** @type {Map<any, EntryFacts>} */
  const given = new Map();
  for (const [at, entry] of [...models, ...settings, ...flights].entries()) {
    const { verified, versions, ...rest } = known[at] ?? {};
    const fact = {
      ...(verified && at < models.length && { verified }),
      ...(versions && settings.some((each) => each === entry) && { versions }),
      ...rest,
    };
    if (Object.keys(fact).length > 0) given.set(entry, fact);
  }
  return given;
}

/** @param {Keeping} keeping */
function reading({ parseLibraryFile, formatLibraryFile, requireLibrary, CodecError }) {
  /** What comes of a text: a library that is right and reads as itself again, or an error of the one kind. */
  return (/** @type {string} */ text) => {
    /** @type {import('../../src/program/index.js').LibraryFile} */
    let file;
    try {
      file = parseLibraryFile(text);
    } catch (error) {
      if (!(error instanceof CodecError)) throw error;
      const { line, column } = error.details;
      const placed = Number.isInteger(line) && Number.isInteger(column);
      hold(
        placed || error.code === 'too-large' || error.field === 'encoding',
        `the error names no place: ${error.message}`,
      );
      hold(
        line === undefined || line <= text.split(/\r\n|\r|\n/).length,
        `the error names a line that does not exist: ${error.message}`,
      );
      hold(error.message.length > 0, 'the error gives no reason');
      return `${error.code} ${error.field}`;
    }
    same(requireLibrary(file.library), file.library);
    same(parseLibraryFile(formatLibraryFile(file.library, file)).library, file.library);
    hold(!('polluted' in {}), 'a prototype has changed');
    return file;
  };
}

/** @type {Record<string, (keeping: Keeping) => fc.IProperty<any>>} */
export const KEPT_LAWS = {
  'file: a library comes back as it was, with what is known of it': (keeping) =>
    fc.property(some, head, fc.array(facts), fc.constantFrom('\n', '\r\n', '\r'), (of, by, known, end) => {
      const all = [...of.models, ...of.settings, ...of.flights];
      const given = factsOf(of, known);
      const text = keeping.formatLibraryFile(of, { ...by, facts: given });
      const file = keeping.parseLibraryFile(`\ufeff${text.replaceAll('\n', end)}`);
      const read = [...file.library.models, ...file.library.settings, ...file.library.flights];
      same(of, file.library);
      same([by.writtenAt, by.writtenBy], [file.writtenAt, file.writtenBy]);
      same([], file.ignored);
      for (const [at, entry] of all.entries()) same(file.facts.get(/** @type {any} */ (read[at])), given.get(entry));
      const broken = breach(schema, JSON.parse(text));
      hold(broken === undefined, `the schema refuses it: ${broken}`);
    }),

  'file: a text that was damaged is right or refused with its place': (keeping) => {
    const read = reading(keeping);
    return fc.property(some, head, fc.array(facts), textDamage, (of, by, known, damage) => {
      read(damage(keeping.formatLibraryFile(of, { ...by, facts: factsOf(of, known) })));
    });
  },

  'file: values that were changed are right or refused, and the schema says the same': (keeping) => {
    const read = reading(keeping);
    return fc.property(some, head, fc.array(facts), valueDamage, (of, by, known, damage) => {
      const value = damage(JSON.parse(keeping.formatLibraryFile(of, { ...by, facts: factsOf(of, known) })));
      const found = read(JSON.stringify(value));
      const broken = breach(schema, value);
      if (typeof found !== 'string')
        hold(broken === undefined, `the reader accepts it, but the schema refuses it: ${broken}`);
      else
        hold(
          broken !== undefined || BEYOND_SCHEMA.some((each) => each.test(found)),
          `${found}, but the schema takes it`,
        );
    });
  },

  'file: any other text is refused': (keeping) => {
    const read = reading(keeping);
    return fc.property(hostileText, (text) =>
      hold(typeof read(text) === 'string', 'a text that is no library was read as one'),
    );
  },

  'link: a setting comes back as it was': ({ encodeLink, decodeLink }) =>
    fc.property(shared, fc.integer({ min: 0, max: 900 }), (of, longest) => {
      const { name, note, tags, at, program: held, modelName } = of;
      const code = encodeLink(of);
      same({ name, note, tags, at, program: held, modelName }, decodeLink(code));
      hold(encodeLink(decodeLink(code)) === code, 'the code that was read is written in another form');
      const { note: cut, ...rest } = decodeLink(encodeLink(of, { longest }));
      same({ name, tags, at, program: held, modelName }, rest);
      hold(cut === note || note.startsWith(cut.replace(/ ?…$/, '')), `the note became ${cut}`);
    }),

  'link: one that was damaged is as it was, or refused': ({ encodeLink, decodeLink, CodecError }) =>
    fc.property(shared, textDamage, (of, damage) => {
      const code = encodeLink(of);
      try {
        hold(encodeLink(decodeLink(damage(code))) === code, 'a damaged link was read as another setting');
      } catch (error) {
        if (!(error instanceof CodecError)) throw error;
        hold(error.code === 'bad-link', `${error.code} ${error.field}`);
      }
    }),

  'link: one that was made to deceive is a setting or refused': ({ encodeLink, decodeLink, CodecError }) => {
    const bytes = fc.oneof(
      fc.uint8Array({ maxLength: 120, size: 'max' }),
      fc
        .tuple(shared, fc.array(fc.tuple(fc.nat(), fc.integer({ min: 0, max: 255 })), { minLength: 1, maxLength: 3 }))
        .map(([of, changes]) => {
          const body = Uint8Array.from(Buffer.from(encodeLink(of), 'base64url')).subarray(0, -4);
          for (const [at, byte] of changes) body[at % body.length] = byte;
          return body;
        }),
    );
    return fc.property(bytes, (body) => {
      const sum = Buffer.alloc(4);
      sum.writeUInt32LE(crc32(body));
      const code = Buffer.concat([body, sum]).toString('base64url');
      try {
        hold(encodeLink(decodeLink(code)) === code, 'a code that was read is written in another form');
      } catch (error) {
        if (!(error instanceof CodecError)) throw error;
        hold(error.field === 'link' || error.field.startsWith('setting.'), `${error.code} ${error.field}`);
      }
    });
  },

  'link: any other text is refused': ({ decodeLink, CodecError }) =>
    fc.property(fc.oneof(hostileText, fc.string({ unit: fc.constantFrom(...'AZaz09-_#s= ') })), (text) => {
      try {
        decodeLink(text);
      } catch (error) {
        if (error instanceof CodecError) return;
        throw error;
      }
      throw new Error('a text that is no link was read as one');
    }),
};
