// What a JSON Schema says of a value: the keywords that public/library.schema.json uses, and no other.

/** @typedef {any} Schema */

/** Keywords that say nothing of a value by themselves. */
const SILENT = new Set(['$schema', '$id', '$defs', 'title', 'description']);

/** @param {unknown} value */
const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/** @type {Record<string, (value: unknown) => boolean>} */
const TYPES = {
  array: Array.isArray,
  boolean: (value) => typeof value === 'boolean',
  integer: Number.isInteger,
  null: (value) => value === null,
  number: (value) => typeof value === 'number',
  object: isObject,
  string: (value) => typeof value === 'string',
};

/**
 * As the standard has it, each keyword judges only values of its own type.
 * @type {Record<string, (value: any) => boolean>}
 */
const ABOUT = {
  required: isObject,
  properties: isObject,
  items: Array.isArray,
  minItems: Array.isArray,
  maxItems: Array.isArray,
  minimum: (value) => typeof value === 'number',
  maximum: (value) => typeof value === 'number',
  minLength: (value) => typeof value === 'string',
  maxLength: (value) => typeof value === 'string',
  pattern: (value) => typeof value === 'string',
};

/**
 * The first place where a value breaks a schema, with the keyword; undefined where it fits.
 * @param {Schema} root @param {unknown} value @param {Schema} schema @param {string} path @returns {string | undefined}
 */
export function breach(root, value, schema = root, path = '') {
  for (const [keyword, wanted] of Object.entries(schema)) {
    if (SILENT.has(keyword) || (ABOUT[keyword] && !ABOUT[keyword](value))) continue;
    const wrong = judge(root, value, keyword, wanted, path);
    if (wrong !== undefined) return wrong;
  }
  return undefined;
}

/**
 * @param {Schema} root @param {any} value @param {string} keyword @param {any} wanted @param {string} path
 * @returns {string | undefined}
 */
function judge(root, value, keyword, wanted, path) {
  const inside = (/** @type {string} */ name) => (path === '' ? name : `${path}.${name}`);
  /** @param {boolean} fits */
  const say = (fits) => (fits ? undefined : `${path}: ${keyword}`);
  /** @param {(string | undefined)[]} all */
  const first = (all) => all.find((wrong) => wrong !== undefined);
  switch (keyword) {
    case '$ref':
      return breach(root, value, root.$defs[wanted.replace('#/$defs/', '')], path);
    case 'type':
      return say(TYPES[wanted]?.(value) ?? false);
    case 'const':
      return say(value === wanted);
    case 'enum':
      return say(wanted.includes(value));
    case 'anyOf':
      return say(wanted.some((/** @type {Schema} */ each) => breach(root, value, each, path) === undefined));
    case 'required':
      return first(wanted.map((/** @type {string} */ name) => (Object.hasOwn(value, name) ? undefined : inside(name))));
    case 'properties':
      return first(
        Object.entries(wanted).map(([name, each]) =>
          Object.hasOwn(value, name) ? breach(root, value[name], each, inside(name)) : undefined,
        ),
      );
    case 'items':
      return first(
        value.map((/** @type {unknown} */ each, /** @type {number} */ at) =>
          breach(root, each, wanted, `${path}[${at}]`),
        ),
      );
    case 'minItems':
      return say(value.length >= wanted);
    case 'maxItems':
      return say(value.length <= wanted);
    case 'minimum':
      return say(value >= wanted);
    case 'maximum':
      return say(value <= wanted);
    case 'minLength':
      return say([...value].length >= wanted);
    case 'maxLength':
      return say([...value].length <= wanted);
    case 'pattern':
      return say(new RegExp(wanted, 'u').test(value));
    default:
      throw new Error(`this reader of schemas does not know the keyword ${keyword}`);
  }
}
