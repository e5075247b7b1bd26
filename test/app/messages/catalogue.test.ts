import { readdirSync, readFileSync } from 'node:fs';
import { FluentBundle, FluentNumber } from '@fluent/bundle';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { say, sentencesOf } from '../../../src/app/messages/catalogue.js';
import { findingText } from '../../../src/app/messages/index.js';
import { checkProgram } from '../../../src/program/index.js';
import { catalogueOf, faultsOf, ofStep, pseudo, treeOf, typesOf } from '../../tools/catalogue.js';
import { en } from '../../tools/en.js';

const FOLDER = 'src/app/messages';
const LANGUAGES = readdirSync(FOLDER).flatMap((file) => /^(.*)\.ftl$/.exec(file)?.[1] ?? []);

const read = (text: string) => catalogueOf(text, 'en.ftl');

interface Sentences {
  readonly bench: {
    readonly title: string;
    readonly waits: string;
    readonly trim: (params: { slot: string }) => string;
    readonly tried: (params: { count: number }) => string;
    readonly timer: (params: { simulated: boolean; name: string; rate: number }) => string;
    readonly 'a-code': string;
  };
}

const ENGLISH = `
## Bench
bench_title = Bench
# Another sentence in this one.
bench_waits = { bench_title }: { bench_a-code }
bench_trim = Trim at { $slot }
bench_tried =
    { $count ->
        [0] Nothing was tried.
        [one] { $count } position was tried.
       *[other] { $count } positions were tried.
    }
bench_timer =
    { $simulated ->
        [true] a simulated { $name } at { $rate } baud
       *[false] the { $name } at { $rate } baud
    }
bench_a-code = waits for 20 s.
`;

/** What the page gets of a translation. */
function said(translation: string, language: string): Sentences {
  const source = read(ENGLISH);
  return sentencesOf<Sentences>(treeOf(source, catalogueOf(translation, `${language}.ftl`)), language);
}

describe('a sentence', () => {
  const { bench } = said(ENGLISH, 'en');

  it('is a text, or a function of its parameters by name', () => {
    expect(bench.title).toBe('Bench');
    expect(bench.trim({ slot: 'DT' })).toBe('Trim at DT');
    expect([0, 1, 2, 1200].map((count) => bench.tried({ count }))).toEqual([
      'Nothing was tried.',
      '1 position was tried.',
      '2 positions were tried.',
      '1200 positions were tried.',
    ]);
    expect(bench.timer({ simulated: true, name: 'F1Q', rate: 9600 })).toBe('a simulated F1Q at 9600 baud');
    expect(bench.timer({ simulated: false, name: 'F1Q', rate: 9600 })).toBe('the F1Q at 9600 baud');
  });

  it('may hold another one, and keeps a figure with its unit', () => {
    expect(bench.waits).toBe('Bench: waits for 20\u00a0s.');
  });

  it('isolates a name from right to left', () => {
    expect(bench.trim({ slot: 'שחף' })).toBe('Trim at \u2068שחף\u2069');
  });

  it('without a parameter shows its name instead of failing', () => {
    expect(say(bench.trim, {})).toBe('Trim at {$slot}');
    expect(say(bench.title, { slot: 'DT' })).toBe('Bench');
  });
});

describe('a translation', () => {
  it('has the plurals of its language', () => {
    const { bench } = said(
      `bench_tried = { $count ->
    [0] Niczego nie wypróbowano.
    [one] Wypróbowano { $count } pozycję.
    [few] Wypróbowano { $count } pozycje.
   *[many] Wypróbowano { $count } pozycji.
}`,
      'pl',
    );
    expect([1, 3, 5, 22].map((count) => bench.tried({ count }).split(' ').at(-1))).toEqual([
      'pozycję.',
      'pozycje.',
      'pozycji.',
      'pozycje.',
    ]);
  });

  it('says in English what it lacks, and stays a function where it needs no parameter', () => {
    const { bench } = said('bench_trim = Hier trimmen', 'de');
    expect(bench.trim({ slot: 'DT' })).toBe('Hier trimmen');
    expect([bench.title, bench.waits]).toEqual(['Bench', 'Bench: waits for 20\u00a0s.']);
  });

  it.each([
    ['bench_titel = Werkbank', 'bench_titel is no sentence of the page'],
    ['bench_title = { $name }', 'bench_title: has $name, which English has not'],
    ['bench_trim = { $slot ->\n [one] { $slot }\n *[other] { $slot }\n}', 'bench_trim: $slot is no number'],
    ['bench_trim = Hier trimmen', 'bench_trim: lacks $slot'],
    ['bench_timer = { $simulated } { $name } { $rate }', 'bench_timer: $simulated is a case, and no text to show'],
    [
      'bench_timer = { $simulated ->\n [wahr] { $name }\n *[false] { $rate }\n}',
      'bench_timer: $simulated is never “wahr”',
    ],
    [
      'bench_tried = { $count ->\n [one] eine\n [few] a\n *[other] { $count }\n}',
      'bench_tried: this language has no plural “few”',
    ],
    ['bench_tried = { $count ->\n [0] keine\n *[other] { $count }\n}', null],
    ['bench_tried = Ausprobiert: { $count }', null],
    ['bench_title = { bench_waits }\nbench_waits = Wartet', null],
  ])('is refused for what English has not, or it lacks: %s', (text, fault) => {
    expect(faultsOf(read(ENGLISH), catalogueOf(text, 'de.ftl'), 'de')).toEqual(fault === null ? [] : [fault]);
  });

  it('is refused without a plural that its language has for a whole number', () => {
    const few = 'bench_tried = { $count ->\n [one] { $count } pozycja\n *[many] { $count } pozycji\n}';
    expect(faultsOf(read(ENGLISH), catalogueOf(few, 'pl.ftl'), 'pl')).toEqual(['bench_tried: lacks the plural “few”']);
  });
});

describe('a file', () => {
  it.each([
    ['a = A\nb c\n', /^en\.ftl:2: /],
    ['a = A { $b\n', /^en\.ftl:\d: /],
    ['a = A\na = B\n', /^en\.ftl: a is there twice$/],
    ['a = { b }\n', /^en\.ftl: a: there is no sentence b$/],
    ['a = { b }\nb = { a }\n', /^en\.ftl: a: it refers to itself$/],
    ['a = { NUMBER($b) }\n', /^en\.ftl: a: only parameters/],
    ['a = { -b }\n-b = B\n', /^en\.ftl: a: only parameters/],
    ['a = { $b ->\n [x] X\n *[y] Y\n} { $b ->\n [x] X\n *[z] Z\n}\n', /^en\.ftl: a: two choices by \$b do not fit$/],
  ])('that cannot be read is refused with the place: %j', (text, message) => {
    expect(() => read(text)).toThrow(message);
  });

  it('has no name for a sentence and a group', () => {
    for (const text of ['a = A\na_b = B\n', 'a_b = B\na = A\n'])
      expect(() => treeOf(read(text), read(text))).toThrow(/is a sentence and a group$/);
  });

  it('gives the types', () => {
    expect(typesOf(read(ENGLISH))).toContain(`export interface PageSentences {
  readonly bench: {
    readonly title: string;
    readonly waits: string;
    readonly trim: (params: { readonly slot: Text }) => string;
    readonly tried: (params: { readonly count: number }) => string;
    readonly timer: (params: { readonly simulated: boolean; readonly name: Text; readonly rate: Text }) => string;
    readonly 'a-code': string;
  };
}

export interface FirstSentences {
}

export interface ManifestSentences {
}

export interface MoreSentences {
}
`);
    expect(typesOf(read('a = { $kind ->\n [dt] DT\n *[start] Start\n}\n'))).toContain("readonly kind: 'dt' | 'start'");
  });
});

it.each(LANGUAGES)('every sentence in %s is said as Fluent says it', (language) => {
  const file = (name: string) => catalogueOf(readFileSync(`${FOLDER}/${name}.ftl`, 'utf8'), `${name}.ftl`);
  const english = file('en');
  const source = new Map([...english, ...file(language)]);
  const bundle = new FluentBundle(language, { useIsolating: false });
  const whole = sentencesOf<Record<string, never>>(treeOf(english, source), language);
  expect(source.size).toBeGreaterThan(1000);
  for (const [id, { params }] of english) {
    const { pattern } = source.get(id) ?? {};
    const sentence = id.split('_').reduce<unknown>((at, name) => (at as Record<string, unknown>)[name], whole);
    for (const [at, count] of [0, 1, 2, 5, 9600].entries()) {
      const given = Object.fromEntries(
        [...params].map(([name, kind]) => {
          if (kind === 'text') return [name, 'M1'];
          return [name, kind === 'number' ? count : (kind[at % kind.length] ?? '')];
        }),
      );
      const said = typeof sentence === 'string' ? sentence : (sentence as (params: object) => string)(given);
      const figures = Object.entries(given).map(([name, value]) => [
        name,
        typeof value === 'number' ? new FluentNumber(value, { useGrouping: false }) : value,
      ]);
      expect(said, id).toBe(bundle.formatPattern(pattern ?? '', Object.fromEntries(figures)));
    }
  }
});

it('the language of the tests has longer words in brackets', () => {
  const source = read(ENGLISH);
  const { bench } = sentencesOf<Sentences>(ofStep(treeOf(source, pseudo(source)), 'page'), 'en');
  expect(bench.title).toBe('⟦Béeñch⟧');
  expect(bench.tried({ count: 1 })).toBe('⟦1 póosíitíióoñ wáas tríiéed.⟧');
});

it('the sentence of every finding has the parameters that come with it', () => {
  const time = fc.constantFrom(0, 5, 5.5, -1, 500, 501, 701, 1200, 65_535, 70_000);
  const position = fc.constantFrom(0, 70, 70.5, 130, 131, 200, 300);
  const program = fc.record({
    identity: fc.record({
      timerClass: fc.constantFrom('Q', 'B', 'E', 'X'),
      functions: fc.constant(3),
      servos: fc.constant(1),
      firmware: fc.constant('536'),
      memories: fc.constant(4),
    }),
    memory: fc.constant(0),
    times: fc.array(time, { minLength: 4, maxLength: 4 }),
    positions: fc.array(fc.array(position, { minLength: 4, maxLength: 4 }), { minLength: 1, maxLength: 1 }),
    idleThrottle: fc.constantFrom(null, 50, 101, 1.5, 70_000),
  });
  const seen = new Set<string>();
  fc.assert(
    fc.property(program, (one) => {
      for (const finding of [...checkProgram(one), ...checkProgram(one, { baseline: one })]) {
        seen.add(finding.code);
        expect(findingText(finding)).not.toContain('{');
      }
    }),
    { numRuns: 1000 },
  );
  expect([...seen].sort()).toEqual(Object.keys(en.findings).sort());
});
