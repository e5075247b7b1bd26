// Reads the sentences of the page, src/app/messages/*.ftl: a file for each language, in the syntax of Project Fluent
// (projectfluent.org). English is the source. From it come the types in sentences.ts, so a sentence, a parameter or the
// sentence of a code that is missing does not compile. `npm run lint` runs this and refuses types that are not those of
// en.ftl, and what a translation has that English has not; `npm run sentences` writes the types.

import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { fileURLToPath } from 'node:url';
import { FluentResource } from '@fluent/bundle';
import { lineOffset, parse } from '@fluent/syntax';

/**
 * @typedef {import('@fluent/bundle').Message['value']} Value
 * @typedef {Exclude<Value, null>} Pattern a text, or its parts
 * @typedef {Exclude<Pattern, string>[number]} Part
 * @typedef {'text' | 'number' | readonly string[]} Kind of a parameter: a list has the only texts that it may be
 * @typedef {object} Sentence
 * @property {Pattern} pattern without references to other sentences
 * @property {ReadonlyMap<string, Kind>} params
 * @typedef {ReadonlyMap<string, Sentence>} Catalogue
 * @typedef {import('../../src/app/messages/catalogue.js').Tree} Tree as the page gets it
 */

const FOLDER = new URL('../../src/app/messages/', import.meta.url);
const MANIFEST = new URL('../../public/manifest.webmanifest', import.meta.url);
const TYPES = new URL('sentences.ts', FOLDER);
const SOURCE = 'en';

/** The steps in which the page is loaded, by the groups of sentences that are not of the step `page`. */
const STEPS = {
  first: ['first'],
  manifest: ['manifest'],
  more: [
    'aboutPage',
    'aboutTimer',
    'checklist',
    'compare',
    'erase',
    'files',
    'firstSteps',
    'flights',
    'guide',
    'library',
    'line',
    'modelBackups',
    'obstacles',
    'overview',
    'ports',
    'preview',
    'print',
    'settings',
    'settle',
    'share',
    'theme',
    'troubles',
    'values',
    'versions',
    'whichModel',
  ],
};

/** Between the names in an id: `bench_ended_over` is `bench.ended.over`. A code may have hyphens. */
const BETWEEN = '_';

/** A figure and its unit stay on one line. */
const UNIT = /(?<=[\d}]) (?=(?:s|min|cm|m\/s|°C|с|хв|см|м\/с)(?![\p{L}/]))/gu;

const PLURALS = ['zero', 'one', 'two', 'few', 'many', 'other'];

/**
 * The sentences of a file.
 * @param {string} text
 * @param {string} name of the file, such as `en.ftl`
 * @returns {Catalogue}
 * @throws an error with the line of what cannot be read
 */
export function catalogueOf(text, name) {
  for (const entry of parse(text, { withSpans: true }).body) {
    if (entry.type !== 'Junk') continue;
    const [{ message = '', span } = {}] = entry.annotations;
    throw new Error(`${name}:${lineOffset(text, span?.start ?? entry.span?.start ?? 0) + 1}: ${message}`);
  }
  const { body } = new FluentResource(text.replace(UNIT, '\u00a0'));
  /** @type {Map<string, Value>} */
  const values = new Map();
  for (const { id, value } of body) {
    if (values.has(id)) throw new Error(`${name}: ${id} is there twice`);
    values.set(id, value);
  }
  return new Map(
    [...values.keys()].map((id) => {
      try {
        const pattern = plain(values, id);
        return [id, { pattern, params: paramsOf(pattern) }];
      } catch (error) {
        throw new Error(`${name}: ${id}: ${/** @type {Error} */ (error).message}`);
      }
    }),
  );
}

/**
 * A sentence with the sentences that it refers to written out: so it needs no other one, and no other file.
 * @param {ReadonlyMap<string, Value>} values @param {string} id @param {readonly string[]} within
 * @returns {Pattern}
 */
function plain(values, id, within = []) {
  const value = values.get(id);
  if (value === undefined || value === null) throw new Error(`there is no sentence ${id}`);
  if (within.includes(id)) throw new Error('it refers to itself');
  /** @param {Pattern} pattern @returns {Pattern} */
  const resolved = (pattern) => {
    if (typeof pattern === 'string') return pattern;
    const parts = pattern.flatMap((part) => {
      if (typeof part === 'string' || part.type === 'var') return [part];
      if (part.type === 'str') return [part.value];
      if (part.type === 'mesg' && part.attr === null) return plain(values, part.name, [...within, id]);
      if (part.type !== 'select' || part.selector.type !== 'var')
        throw new Error('only parameters, choices by a parameter and other sentences may stand in braces');
      return [{ ...part, variants: part.variants.map((each) => ({ ...each, value: resolved(each.value) })) }];
    });
    return joined(parts);
  };
  return resolved(value);
}

/** Texts beside each other become one. @param {Exclude<Pattern, string>} parts @returns {Pattern} */
function joined(parts) {
  /** @type {Exclude<Pattern, string>} */
  const list = [];
  for (const part of parts) {
    const last = list.at(-1);
    if (typeof part === 'string' && typeof last === 'string') list[list.length - 1] = last + part;
    else list.push(part);
  }
  const [only = ''] = list;
  return list.length < 2 && typeof only === 'string' ? only : list;
}

/** All that stands in braces, also within choices. @param {Pattern} pattern @returns {Exclude<Part, string>[]} */
function bracesIn(pattern) {
  if (typeof pattern === 'string') return [];
  return pattern.flatMap((part) => {
    if (typeof part === 'string') return [];
    return [part, ...(part.type === 'select' ? part.variants.flatMap(({ value }) => bracesIn(value)) : [])];
  });
}

/** The parameters of a sentence. @param {Pattern} pattern */
function paramsOf(pattern) {
  /** @type {Map<string, Kind>} */
  const params = new Map();
  for (const part of bracesIn(pattern)) {
    if (part.type === 'var') params.set(part.name, params.get(part.name) ?? 'text');
    if (part.type !== 'select' || part.selector.type !== 'var') continue;
    const { name } = part.selector;
    const keys = part.variants.map(({ key }) => String(key.value));
    const kind = keys.every((key) => PLURALS.includes(key) || Number.isFinite(Number(key))) ? 'number' : keys;
    const known = params.get(name) ?? 'text';
    if (known !== 'text' && String(known) !== String(kind)) throw new Error(`two choices by $${name} do not fit`);
    params.set(name, kind);
  }
  return params;
}

/**
 * What is wrong with a translation.
 * @param {Catalogue} source @param {Catalogue} other @param {string} language such as `de`
 * @returns {string[]} a sentence for each
 */
export function faultsOf(source, other, language) {
  const { pluralCategories } = new Intl.PluralRules(language).resolvedOptions();
  /** @type {(name: string, kind: Kind, known: Kind | undefined) => string | null} */
  const fault = (name, kind, known) => {
    if (!known) return `has $${name}, which English has not`;
    if (kind === 'number' && known !== 'number') return `$${name} is no number`;
    if (kind === 'text' && typeof known === 'object') return `$${name} is a case, and no text to show`;
    if (typeof kind !== 'object') return null;
    const wrong = kind.find((key) => !known.includes(key));
    return wrong === undefined ? null : `$${name} is never “${wrong}”`;
  };
  const needed = Array.from({ length: 200 }, (_, count) => new Intl.PluralRules(language).select(count));
  return [...other].flatMap(([id, { pattern, params }]) => {
    const known = source.get(id);
    if (!known) return [`${id} is no sentence of the page`];
    const found = [...params].map(([name, kind]) => fault(name, kind, known.params.get(name)));
    for (const name of shownIn(known.pattern)) if (!shownIn(pattern).includes(name)) found.push(`lacks $${name}`);
    for (const keys of pluralsIn(pattern)) {
      const never = keys.find((each) => !(/** @type {string[]} */ (pluralCategories).includes(each)));
      if (never) found.push(`this language has no plural “${never}”`);
      const lacking = needed.find((each) => keys.length > 1 && !keys.includes(each));
      if (lacking) found.push(`lacks the plural “${lacking}”`);
    }
    return found.filter((each) => each !== null).map((each) => `${id}: ${each}`);
  });
}

/** The parameters that a reader sees. @param {Pattern} pattern */
const shownIn = (pattern) => bracesIn(pattern).flatMap((part) => (part.type === 'var' ? [part.name] : []));

/** The plurals of each choice, without its numbers such as `[0]`. @param {Pattern} pattern */
function pluralsIn(pattern) {
  return bracesIn(pattern)
    .filter((part) => part.type === 'select')
    .map(({ variants }) => variants.map(({ key }) => String(key.value)).filter((key) => PLURALS.includes(key)));
}

/**
 * The sentences as the page gets them. What a translation lacks is in English. A sentence with parameters is a list,
 * any other a text, as English has it.
 * @param {Catalogue} source @param {Catalogue} said
 * @returns {Tree}
 */
export function treeOf(source, said) {
  /** @type {{ [name: string]: any }} */
  const tree = {};
  for (const [id, { pattern, params }] of source) {
    const { pattern: own } = said.get(id) ?? { pattern };
    const brief = short(own);
    put(tree, id, params.size > 0 && typeof brief === 'string' ? [brief] : brief);
  }
  return tree;
}

/**
 * A sentence in the form of the page, which is the same with fewer words: `Pattern` in catalogue.ts.
 * @param {Pattern} pattern @returns {string | import('../../src/app/messages/catalogue.js').Pattern}
 */
function short(pattern) {
  if (typeof pattern === 'string') return pattern;
  return pattern.map((part) => {
    if (typeof part === 'string') return part;
    if (part.type === 'var') return [part.name];
    if (part.type !== 'select' || part.selector.type !== 'var') throw new Error(`a part is ${part.type}`);
    const variants = part.variants.map(({ key, value }) => [String(key.value), short(value)]);
    return [part.selector.name, Object.fromEntries(variants), String(part.variants[part.star]?.key.value)];
  });
}

/** @template T @param {{ [name: string]: any }} tree @param {string} id @param {T} value */
function put(tree, id, value) {
  const path = id.split(BETWEEN);
  const last = path.pop() ?? '';
  let at = tree;
  for (const name of path) {
    at[name] ??= {};
    at = at[name];
  }
  if (typeof at !== 'object' || Array.isArray(at) || last in at) throw new Error(`${id} is a sentence and a group`);
  at[last] = value;
}

/** @param {string} group @returns {string} */
function stepOf(group) {
  return Object.entries(STEPS).find(([, groups]) => groups.includes(group))?.[0] ?? 'page';
}

/** The groups of a tree that are loaded in a step. @param {Tree} tree @param {string} step @returns {Tree} */
export function ofStep(tree, step) {
  return Object.fromEntries(Object.entries(tree).filter(([group]) => stepOf(group) === step));
}

/** The types of the English sentences. @param {Catalogue} source */
export function typesOf(source) {
  /** @type {{ [name: string]: any }} */
  const types = {};
  for (const [id, { params }] of source) put(types, id, [typeOf(params)]);
  /** @type {(node: any, indent: string) => string} */
  const written = (node, indent) => {
    if (Array.isArray(node)) return node[0];
    const lines = Object.entries(node).map(([name, each]) => {
      const key = /^[A-Za-z]\w*$/.test(name) ? name : `'${name}'`;
      return `${indent}  readonly ${key}: ${written(each, `${indent}  `)};\n`;
    });
    return `{\n${lines.join('')}${indent}}`;
  };
  const steps = ['page', ...Object.keys(STEPS)].map((step) => {
    const name = `${step[0]?.toUpperCase()}${step.slice(1)}Sentences`;
    return `\nexport interface ${name} ${written(ofStep(types, step), '')}\n`;
  });
  return `// Made from en.ftl by \`npm run sentences\`.\n\ntype Text = string | number;\n${steps.join('')}`;
}

/** @param {ReadonlyMap<string, Kind>} params */
function typeOf(params) {
  if (params.size === 0) return 'string';
  /** @type {(kind: Kind) => string} */
  const kindOf = (kind) => {
    if (kind === 'text') return 'Text';
    if (kind === 'number') return kind;
    if (kind.every((key) => ['true', 'false'].includes(key))) return 'boolean';
    return kind
      .toSorted()
      .map((key) => `'${key}'`)
      .join(' | ');
  };
  const list = [...params].map(([name, kind]) => `readonly ${name}: ${kindOf(kind)}`);
  return `(params: { ${list.join('; ')} }) => string`;
}

/** The languages beside English, each with the path of its file. @returns {[language: string, path: string][]} */
function translations() {
  const languages = readdirSync(FOLDER).flatMap((file) => /^([\w-]+)\.ftl$/.exec(file)?.[1] ?? []);
  return languages
    .filter((language) => language !== SOURCE)
    .map((language) => [language, fileURLToPath(new URL(`${language}.ftl`, FOLDER))]);
}

/** @param {string} path of a file */
const catalogueIn = (path) => catalogueOf(readFileSync(path, 'utf8'), basename(path));

/**
 * A language that only tests speak: longer words with marks, and brackets around each sentence. A text without brackets
 * does not come from the file; one with two pairs is put together from pieces, which other languages cannot do.
 * @param {Catalogue} source @returns {Catalogue}
 */
export function pseudo(source) {
  /** @type {(text: string) => string} */
  const marked = (text) =>
    text
      .replace(/[aeiou]/gi, (vowel) => `${vowel}\u0301${vowel.toLowerCase()}`)
      .replace(/n/g, 'ñ')
      .normalize('NFC');
  /** @type {(each: Pattern) => Pattern} */
  const said = (each) => {
    if (typeof each === 'string') return marked(each);
    return each.map((part) => {
      if (typeof part === 'string') return marked(part);
      if (part.type !== 'select') return part;
      return { ...part, variants: part.variants.map((one) => ({ ...one, value: said(one.value) })) };
    });
  };
  const whole = (/** @type {Pattern} */ pattern) => joined(['⟦', ...[said(pattern)].flat(), '⟧']);
  return new Map([...source].map(([id, each]) => [id, { ...each, pattern: whole(each.pattern) }]));
}

/**
 * Gives the page its sentences: `import tree from './de.ftl?page'`. They are a script, because the page may fetch
 * nothing else, and are read here, so the page needs no reader for them.
 * @param {object} [options]
 * @param {boolean} [options.inPseudo] every language but English is that of the tests
 * @returns {import('vite').Plugin}
 */
export function sentences({ inPseudo = false } = {}) {
  return {
    name: 'sentences',
    load: {
      filter: { id: /\.ftl\?/ },
      handler(id) {
        const [path = '', step = ''] = id.split('?');
        const source = fileURLToPath(new URL(`${SOURCE}.ftl`, FOLDER));
        for (const file of new Set([path, source])) this.addWatchFile(file);
        const english = catalogueIn(source);
        const said = inPseudo && path !== source ? pseudo(english) : catalogueIn(path);
        return `export default ${JSON.stringify(ofStep(treeOf(english, said), step))}`;
      },
    },
    generateBundle() {
      const manifest = readFileSync(MANIFEST, 'utf8');
      const source = catalogueIn(fileURLToPath(new URL(`${SOURCE}.ftl`, FOLDER)));
      for (const [language, path] of translations()) {
        const text = manifestOf(manifest, source, catalogueIn(path), language);
        this.emitFile({ type: 'asset', fileName: `manifest.${language}.webmanifest`, source: text });
      }
    },
  };
}

/**
 * The manifest of the page in a language: that in English, with each of its texts translated.
 * @param {string} manifest @param {Catalogue} source @param {Catalogue} said @param {string} language
 */
export function manifestOf(manifest, source, said, language) {
  const texts = new Map(
    [...source].flatMap(([id, { pattern }]) => (id.startsWith('manifest_') ? [[pattern, said.get(id)?.pattern]] : [])),
  );
  return JSON.stringify({
    ...JSON.parse(manifest, (_, value) => (typeof value === 'string' && texts.get(value)) || value),
    lang: language,
  });
}

/** @param {boolean} writes the types, instead of comparing them */
function main(writes) {
  const source = catalogueIn(fileURLToPath(new URL(`${SOURCE}.ftl`, FOLDER)));
  const types = typesOf(source);
  if (writes) writeFileSync(TYPES, types);
  const found = readFileSync(TYPES, 'utf8') === types ? [] : ['sentences.ts is not that of en.ftl: npm run sentences'];
  for (const [language, path] of translations()) {
    const other = catalogueIn(path);
    found.push(...faultsOf(source, other, language).map((each) => `${language}.ftl: ${each}`));
    const missing = [...source.keys()].filter((id) => !other.has(id));
    console.log(`${language}.ftl: ${missing.length === 0 ? 'whole' : `in English are ${missing.join(', ')}`}`);
  }
  for (const each of found) console.error(`src/app/messages/${each}`);
  process.exitCode = found.length > 0 ? 1 : 0;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) main(process.argv.includes('--write'));
