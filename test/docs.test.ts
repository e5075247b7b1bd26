import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { lowered, overruns, sentencesIn } from './tools/budgets.js';
import { longComments } from './tools/columns.js';
import { connectionHtml } from './tools/connection-page.js';
import { root } from './tools/pack.js';
import { breaches } from './tools/page-order.js';
import { inDocs } from './tools/picture-states.js';
import { deadClasses, dearSelectors, flaws, strayClasses, strayThresholds } from './tools/styles.js';

const texts = [
  ...['README.md', 'CONTRIBUTING.md', 'CHANGELOG.md', 'SECURITY.md', 'test/rig/README.md'],
  ...readdirSync(join(root, 'docs'))
    .filter((file) => file.endsWith('.md'))
    .map((file) => `docs/${file}`),
];

/** Each relative link of a text, with the heading it goes to. */
function linksOf(file: string): { path: string; heading: string | undefined }[] {
  const text = readFileSync(join(root, file), 'utf8').replace(/```.*?```/gs, '');
  return [...text.matchAll(/\]\((?!\w+:)([^)#\s]*)(?:#([^)\s]+))?\)/g)].map(([, path, heading]) => ({
    path: path === '' ? file : join(dirname(file), path as string),
    heading,
  }));
}

/** The headings of a text as links to them are spelt. */
function headingsOf(file: string): string[] {
  const text = readFileSync(join(root, file), 'utf8');
  return [...text.matchAll(/^#+ (.*)$/gm)].map(([, title]) =>
    (title as string)
      .toLowerCase()
      .replace(/[^\p{L}\p{N}\s_-]/gu, '')
      .replaceAll(' ', '-'),
  );
}

describe('the docs', () => {
  it.each(texts)('%s links to what is there', (file) => {
    for (const { path, heading } of linksOf(file)) {
      expect(existsSync(join(root, path)), `${file} links to ${path}, which does not exist`).toBe(true);
      if (heading) expect(headingsOf(path), `${file} links to a heading that ${path} does not have`).toContain(heading);
    }
  });

  // What the changelog names may be gone.
  it.each(texts.filter((file) => file !== 'CHANGELOG.md'))('%s names sources that are there', (file) => {
    const places = ['', 'src', 'src/app', 'test', 'test/app'].map((folder) => join(root, folder));
    const named = [...readFileSync(join(root, file), 'utf8').matchAll(/`((?:[\w-]+\/)+[\w.-]+\.(?:tsx?|css|html))`/g)];
    const gone = named.filter(([, path = '']) => !places.some((place) => existsSync(join(place, path))));
    expect(gone.map(([, path]) => path)).toEqual([]);
  });

  it('show each of the pictures that are kept, and keep no other', () => {
    const shown = texts.flatMap(linksOf).map(({ path }) => path);
    const kept = readdirSync(join(root, 'docs/pictures')).map((file) => file.replace('.webp', ''));
    expect(kept.sort()).toEqual([...inDocs].sort());
    for (const name of inDocs)
      expect(shown, `no text shows the picture ${name}`).toContain(`docs/pictures/${name}.webp`);
  });

  it('name the browsers that reach a timer as the page does', () => {
    const sentences = readFileSync(join(root, 'src/app/messages/en.ftl'), 'utf8');
    const versions = sentences.matchAll(/^firstVersions_\w+ = (\d+)$/gm);
    const [android, bluetooth, last, androidCable] = Array.from(versions, ([, version]) => Number(version));
    expect(last).toBe(Number(android) - 1);
    for (const file of ['docs/using-the-page.md', 'docs/connection.md']) {
      const text = readFileSync(join(root, file), 'utf8').replace(/\s+/g, ' ');
      expect(text).toContain(`Chrome ${android} or later. Chrome ${bluetooth} to ${last} over Bluetooth only.`);
      expect(text).toContain(`A cable needs Android ${androidCable}`);
    }
  });

  it('become the page of the connection, with each heading, step and line to copy', () => {
    const made = connectionHtml('# A title\n\nTwo\nlines.\n\n## Part\n\n- One `x`\n  more:\n\n      a <b>\n\n- Two\n');
    expect(made.slice(made.indexOf('<body>'))).toBe(
      '<body>\n<h1>A title</h1>\n<p>Two lines.</p>\n<h2>Part</h2>\n<ul>\n<li>One <code>x</code> more:\n' +
        '<pre><code>a &lt;b&gt;</code></pre></li>\n<li>Two</li>\n</ul>\n</body>\n</html>\n',
    );
    const text = readFileSync(join(root, 'docs/connection.md'), 'utf8');
    const whole = connectionHtml(text);
    expect(whole.match(/<li>/g)?.length).toBe(text.match(/^- /gm)?.length);
    expect(whole.match(/<pre>/g)?.length).toBe(text.match(/\n\n {6}/g)?.length);
    expect(() => connectionHtml('| a | table |')).toThrow('a form that its page does not know');
  });

  it('name tests that are there for what the page says', () => {
    const text = readFileSync(join(root, 'docs/claims.md'), 'utf8');
    const named = [...text.matchAll(/`([\w/.-]+\.test\.tsx?)`([^`|\n]*)/g)];
    expect(named.length).toBeGreaterThan(30);
    for (const [, file = '', names = ''] of named) {
      const tests = readFileSync(join(root, 'test', file), 'utf8');
      for (const [, name] of names.matchAll(/“([^”]+)”/g))
        expect(tests, `docs/claims.md names a test that ${file} does not have: ${name}`).toContain(name);
    }
  });

  it.each(texts)('%s holds its lines to 120 columns', (file) => {
    const prose = readFileSync(join(root, file), 'utf8').replace(/```.*?```/gs, '');
    expect(prose.split('\n').filter((line) => line.length > 120 && !line.startsWith('|'))).toEqual([]);
  });
});

/** What a tool of `npm run lint` finds: a part of its one sentence, or nothing. */
type Found = readonly [what: string, found: readonly string[], fault: string | null];
const isFound = (_: string, found: readonly string[], fault: string | null): void =>
  expect(found).toEqual(fault === null ? [] : [expect.stringContaining(fault)]);

it('comments are found where they pass 120 columns, but code, and an address that fills its line, are not', () => {
  const long = 'word '.repeat(24);
  const lines = ['// short', `  // ${long}`, ` * ${long}`, `const text = '${long}';`, `// https://${'a'.repeat(120)}`];
  expect(longComments(lines.join('\n'))).toEqual([2, 3]);
});

describe('in the order of the page', () => {
  const imports = (file: string, path: string) => breaches(file, `import { a } from '${path}';`);

  it.each<Found>([
    ['a feature that looks up', imports('bench/stand.ts', '../shell/header.js'), 'app/bench may not use app/shell'],
    ['one that looks for its models', imports('bench/panel.tsx', '../models.js'), 'app/bench may not use app/app'],
    ['one that knows another', imports('memories/copy.ts', '../bench/a.js'), 'app/memories may not use app/bench'],
    ['also later', breaches('memories/a.ts', "await import('../bench/a.js');"), 'app/memories may not use app/bench'],
    ['what lies below', imports('editing/units.ts', '../work/session.js'), 'app/editing may not use app/work'],
    ['a timer that knows what is kept', imports('timer/a.ts', '../records/b.js'), 'app/timer may not use app/records'],
    [
      'a folder in a folder',
      imports('timeline/preview/a.ts', '../../program/b.js'),
      'app/timeline may not use app/program',
    ],
    [
      'a folder without a place',
      imports('parts/a.tsx', '../ui/b.js'),
      'the folder parts is not in the order of the page',
    ],
    ['a room past its door', imports('timer/a.ts', '../../serial/ports.js'), 'a room is entered through its index.js'],
    ['the simulator', imports('timer/a.ts', '../../simulator/index.js'), 'only connect/simulated-timer.ts may'],
    ['the simulator, where it may', imports('connect/simulated-timer.ts', '../../simulator/index.js'), null],
    ['what looks down', imports('program/table.tsx', '../ui/modal.js'), null],
    ['what may know another', breaches('program/table.tsx', "import '../bench/b.js';"), null],
    ['what looks beside', imports('timeline/preview/player.ts', '../scale.js'), null],
    ['a component that writes', breaches('bench/a.tsx', 'session.notice.value = null'), 'bench/a.tsx writes '],
    ['one that counts', breaches('bench/a.tsx', 'model.front.value++'), 'bench/a.tsx writes '],
    ['one that adds', breaches('bench/a.tsx', 'model.count.value += 2'), 'bench/a.tsx writes '],
    ['a model that writes', breaches('bench/a.ts', 'model.front.value++'), null],
    ['own signals', breaches('bench/a.tsx', 'open.value = true; if (a.b.value === 1) {}'), null],
    ['who asks a source', breaches('print/a.ts', 'session.knowledge.of(memory)'), 'ask session.standings'],
    ['a shorter way', breaches('print/a.ts', 'recognition.model.value'), 'ask session.origin'],
    [
      'parts of it',
      breaches('print/a.ts', 'const { model, tells } = this.#session.recognition;'),
      'ask session.origin',
    ],
    ['the answer itself', breaches('work/origin.ts', 'session.knowledge.of(memory)'), null],
  ])('%s', isFound);
});

describe('of the styles', () => {
  const rule = (declaration: string) => `/* #fff */\n.a:hover {\n  ${declaration};\n}\n`;
  const shape = (condition: string) =>
    strayThresholds('line/a.css', `${condition} {\n  .a {\n    margin: 0;\n  }\n}\n`);
  const outside = 'stands in ui/tokens.css';
  const noShape = 'no shape of the window';
  const deep =
    '.a:has(> :not(.b)):focus input {\n  top: 0;\n}\n\n.d :has(svg):hover,\nth:has([open]) {\n  top: 0;\n}\n';
  const homes = new Map([
    ['ui/modal.css', '.dialog > .buttons {\n  margin: 0;\n}\n'],
    [
      'line/a.css',
      '@media print {\n  .a, dialog:has(.b, .c) .dialog {\n    margin: 0;\n  }\n\n  .dialog {\n    margin: 0;\n  }\n}\n',
    ],
  ]);
  const gone = new Map([['line/a.css', '.a:has(.b) .on-a4,\n.gone {\n  margin: 0;\n}\n']]);

  it.each<Found>([
    ['a colour in hexadecimal', flaws('line/a.css', rule('border: 1px solid #a51717')), outside],
    ['a colour as a function', flaws('line/a.css', rule('background: rgb(8 14 20 / 60%)')), outside],
    ['a colour by name', flaws('line/a.css', rule('color: white')), outside],
    ['a fifth size of type', flaws('line/a.css', rule('font-size: 0.9rem')), outside],
    ['a size of type of this window', flaws('line/a.css', rule('font-size: clamp(1rem, 2vw, 2rem)')), outside],
    ['a step beside the scale of space', flaws('line/a.css', rule('margin-inline: 0.6rem auto')), outside],
    ['a colour in the tokens', flaws('ui/tokens.css', rule('color: white')), null],
    ['a token', flaws('line/a.css', rule('padding: 0 var(--space-2);\n  font-size: var(--type-small)')), null],
    [
      'what looks through the whole table',
      dearSelectors('program/a.css', deep),
      '.a:has(> :not(.b)):focus input: styles more',
    ],
    ['the same where no key is pressed', dearSelectors('print/a.css', deep), null],
    ['two shapes', shape('@media (--phone), (--side)'), null],
    ['a shape and a pointer', shape('@media (--laptop) and (pointer: fine)'), null],
    ['paper', shape('@media print'), null],
    ['the edge of a part', shape('@container program-table (max-width: 480px)'), null],
    ['a width', shape('@media (max-width: 47.5em)'), noShape],
    ['a shape and a height', shape('@media (--phone) and (height < 40em)'), noShape],
    ['another shape', shape('@media (--phone), (--small)'), noShape],
    ['another form of an edge', shape('@container program-table (width < 480px)'), noShape],
    ['another edge', shape('@container program-table (max-width: 530px)'), noShape],
    ['no component', deadClasses(gone, '<p class={`a b on-$'.concat('{paper}`} />')), '.gone: no component uses it'],
    ['two homes', strayClasses(homes), 'line/a.css: .dialog has its home in ui/modal.css'],
  ])('%s', isFound);
});

describe('the size of the code', () => {
  it('counts the sentences of each group', () => {
    const text = `# A comment = no sentence.
line_title = Line
line_names_a-code =
    { $count ->
        [one] { $count } = one
       *[other] { $count }
    }
cancel = Cancel
delete = Delete
`;
    expect(sentencesIn(text)).toEqual({ alone: 2, line: 2 });
  });

  it('is held by ceilings, which only come down', () => {
    const figures = (client: number, sentences: number) => ({
      lines: { 'src/client': client },
      styles: 1,
      tests: 1,
      sentences: { line: sentences },
    });
    expect(overruns(figures(11, 3), figures(10, 4))).toEqual([expect.stringContaining('lines of src/client: 11')]);
    expect(overruns({ ...figures(1, 1), lines: { 'src/other': 1 } }, figures(1, 1))).toHaveLength(1);
    expect(lowered(figures(11, 3), figures(10, 4))).toEqual(figures(10, 3));
  });
});
