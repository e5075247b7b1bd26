// Checks the styles of the page: colours and sizes are defined only in ui/tokens.css, a class means one thing, and the
// window has few shapes.
// Part of `npm run lint`.

import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const page = new URL('../../src/app/', import.meta.url);

/** The one file that may define colours and sizes. */
const TOKENS = 'ui/tokens.css';

const COLOUR =
  /#[0-9a-f]{3,8}\b|\b(?:rgb|hsl|hwb|lab|lch|oklab|oklch|color|color-mix)a?\(|:[^;]*\b(?:black|white|red|green|blue|gr[ae]y)\b/i;

/** A size of type as it is, or smaller where there is less room. */
const TYPE = /^(?:inherit|var\(--type-\w+\)|min\(var\(--type-\w+\), .*(?:cqw|vw|-column).*\))$/;

/** The properties with the scale of space. A pixel or two are an optical correction. */
const SPACED = /^(?:padding|margin|gap|row-gap|column-gap)\b/;

/**
 * What is wrong in one file of styles.
 * @param {string} file from src/app, such as `program/presets.css`
 * @param {string} text what stands in it
 * @returns {string[]} a sentence for each
 */
export function flaws(file, text) {
  if (file === TOKENS) return [];
  return declarationsOf(text).flatMap(([property, value]) => {
    const said = `${file}: ${property}: ${value}`;
    if (COLOUR.test(`:${value}`)) return [`${said}: a colour stands in ${TOKENS}`];
    if (property === 'font-size' && !TYPE.test(value)) return [`${said}: a size of type stands in ${TOKENS}`];
    if (SPACED.test(property) && /\dr?em\b/.test(value)) return [`${said}: the scale of space stands in ${TOKENS}`];
    return [];
  });
}

/**
 * The classes that are styled in more than one file: each has one home, the file in which selectors begin with it.
 * @param {ReadonlyMap<string, string>} texts by file
 * @returns {string[]} a sentence for each
 */
export function strayClasses(texts) {
  /** @type {Map<string, string>} */
  const homes = new Map();
  return [...texts].flatMap(([file, text]) =>
    [...new Set(selectorsOf(text).map((selector) => /\.([a-z][\w-]*)/.exec(selector)?.[1]))].flatMap((name) => {
      if (name === undefined) return [];
      const home = homes.get(name) ?? file;
      homes.set(name, home);
      return home === file ? [] : [`${file}: .${name} has its home in ${home}`];
    }),
  );
}

/** The content of these folders changes at each key. */
const AT_EACH_KEY = /^(?:program|timeline)\//;
const LOOKS_DOWN = /:has\((?:[^()]|\([^()]*\))*\)[^\s>+~]*[\s>+~]+\S/;

/**
 * Selectors with `:has()` that style a part of what they search. Whenever anything comes or goes in it,
 * such as an old value, the whole part is styled again. A selector that styles the searched element itself is cheap.
 * @param {string} file
 * @param {string} text
 * @returns {string[]} a sentence for each
 */
export function dearSelectors(file, text) {
  if (!AT_EACH_KEY.test(file)) return [];
  return selectorsOf(text)
    .filter((selector) => LOOKS_DOWN.test(selector.trim()))
    .map((selector) => `${file}: ${selector.trim()}: styles more than what a key changes`);
}

/** The shapes of the window, by the names that the styles have for them. */
const SHAPES = [...readFileSync(new URL('ui/shapes.ts', page), 'utf8').matchAll(/^ {2}(\w+): '/gm)].map(
  ([, name]) => `--${name}`,
);

/** Parts that are drawn by their own room, each with its one edge. */
const PARTS = new Map([
  ['program-table', '(max-width: 480px)'],
  ['program-side', '(max-height: 670px)'],
  ['edit-sheet', '(max-width: 17rem)'],
  ['', '(max-width: 27rem)'],
]);

/**
 * Thresholds that are none of the few shapes of the window, or of a part.
 * @param {string} file
 * @param {string} text
 * @returns {string[]} a sentence for each
 */
export function strayThresholds(file, text) {
  return [...bare(text).matchAll(/@(media|container)([^{]*)\{/g)].flatMap(([, rule, condition = '']) => {
    const [, name = '', edge = ''] = /^ ([\w-]*) ?(.*) $/.exec(condition) ?? [];
    const isKnown =
      rule === 'container'
        ? PARTS.get(name) === edge
        : !/width|height/.test(condition) &&
          (condition.match(/--\w+/g) ?? []).every((/** @type {string} */ shape) => SHAPES.includes(shape));
    return isKnown ? [] : [`${file}:${condition}: no shape of the window, see ui/shapes.ts`];
  });
}

/**
 * Classes that no component uses.
 * @param {ReadonlyMap<string, string>} styles by file
 * @param {string} source all components; of a class such as `on-${paper}` only the beginning stands there
 * @returns {string[]} a sentence for each
 */
export function deadClasses(styles, source) {
  const words = new Set(source.match(/[A-Za-z][\w-]*/g));
  const beginnings = [...source.matchAll(/([a-z][\w-]*-)\$\{/g)].map(([, beginning = '']) => beginning);
  const isUsed = (/** @type {string} */ name) =>
    words.has(name) || name.endsWith('-view') || beginnings.some((beginning) => name.startsWith(beginning));
  return [...styles].flatMap(([file, text]) => {
    const names = selectorsOf(text).flatMap((selector) =>
      [...selector.matchAll(/\.([a-z][\w-]*)/g)].map(([, name = '']) => name),
    );
    return [...new Set(names)].filter((name) => !isUsed(name)).map((name) => `${file}: .${name}: no component uses it`);
  });
}

/** All files of styles, with what is wrong in them. */
function flawsOfPage() {
  const files = readdirSync(page, { recursive: true, encoding: 'utf8' }).sort();
  const read = (/** @type {string} */ file) => readFileSync(new URL(file, page), 'utf8');
  const texts = new Map(files.filter((file) => file.endsWith('.css')).map((file) => [file, read(file)]));
  // What the page says is no name of a class.
  const source = files.filter((file) => /\.(?:tsx?|html)$/.test(file) && !file.startsWith('messages')).map(read);
  return [
    ...[...texts].flatMap(([file, text]) => [
      ...flaws(file, text),
      ...strayThresholds(file, text),
      ...dearSelectors(file, text),
    ]),
    ...strayClasses(texts),
    ...deadClasses(texts, bare(source.join('\n'))),
  ];
}

/** @param {string} text @returns {[property: string, value: string][]} */
function declarationsOf(text) {
  return [...bare(text).matchAll(/([\w-]+):\s*([^;{}]+);/g)].map(([, property = '', value = '']) => [
    property,
    value.replace(/\s+/g, ' '),
  ]);
}

/** @param {string} text @returns {string[]} each as it is written, with no commas but in brackets */
function selectorsOf(text) {
  return [...bare(text).matchAll(/([^{};]+)\{/g)]
    .map(([, prelude = '']) => prelude.trim())
    .filter((prelude) => !prelude.startsWith('@'))
    .flatMap((prelude) => prelude.split(/,(?![^(]*\))/));
}

/** @param {string} text */
function bare(text) {
  return text.replace(/\/\*.*?\*\//gs, '');
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const found = flawsOfPage();
  for (const each of found) console.error(each);
  process.exitCode = found.length > 0 ? 1 : 0;
}
