import { apart } from './apart.js';

/** The variants of a choice by their keys, and the key of the one for all else. */
type Choice = readonly [variants: Readonly<Record<string, string | Pattern>>, otherwise: string];

/** A sentence with parameters: texts, parameters by their names, and choices by a parameter. */
export type Pattern = readonly (string | readonly [name: string] | readonly [name: string, ...Choice])[];

/** The sentences of a language as the build makes them of its file: test/tools/catalogue.js. */
export interface Tree {
  readonly [name: string]: string | Pattern | Tree;
}

type Params = Readonly<Record<string, string | number | boolean>>;

/**
 * The sentences of a tree: texts, and functions of named parameters that make one.
 * @param language for its plurals: `en`, `de-AT`.
 * @typeParam Sentences as the English file has them. The build sees to it that every tree has them all.
 */
export function sentencesOf<Sentences>(tree: Tree, language: string): Sentences {
  const plurals = new Intl.PluralRules(language);
  // A number is no figure of a timer: those come as texts, in their form.
  const figures = new Intl.NumberFormat(language, { useGrouping: false });
  const made = (pattern: Pattern, params: Params): string =>
    pattern
      .map((part) => {
        if (typeof part === 'string') return part;
        const [name, variants, otherwise = ''] = part;
        const value = params[name];
        // What is missing is shown by its name: a page with a flaw is better than none.
        if (value === undefined) return `{$${name}}`;
        if (!variants) return typeof value === 'number' ? figures.format(value) : apart(String(value));
        const keys = typeof value === 'number' ? [String(value), plurals.select(value)] : [String(value)];
        const variant = variants[keys.find((key) => Object.hasOwn(variants, key)) ?? otherwise] ?? '';
        return typeof variant === 'string' ? variant : made(variant, params);
      })
      .join('');
  const said = (entry: Tree[string]): unknown => {
    if (typeof entry === 'string') return entry;
    if (isPattern(entry)) return (params: Params) => made(entry, params);
    return Object.fromEntries(Object.entries(entry).map(([name, each]) => [name, said(each)]));
  };
  return said(tree) as Sentences;
}

function isPattern(entry: Pattern | Tree): entry is Pattern {
  return Array.isArray(entry);
}

/**
 * A sentence that is found by a code, with the parameters that came with the code. Only there the compiler cannot
 * compare them: a test does.
 */
export function say(sentence: string | ((params: never) => string), params: Params): string {
  return typeof sentence === 'string' ? sentence : (sentence as (params: Params) => string)(params);
}
