import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { lowered, overruns, sentencesIn } from './tools/budgets.js';
import { longComments } from './tools/columns.js';
import { connectionHtml } from './tools/connection-page.js';
import { root } from './tools/pack.js';
import { breaches } from './tools/page-order.js';
import { inDocs } from './tools/picture-states.js';
import { deadClasses, dearSelectors, flaws, flawsOfPage, strayClasses, strayThresholds } from './tools/styles.js';

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

describe('the workflows', () => {
  const folder = join(root, '.github/workflows');
  it.each(readdirSync(folder))('%s take what they use by its digest, and run scripts that there are', (file) => {
    const text = readFileSync(join(folder, file), 'utf8');
    const used = [...text.matchAll(/^\s*(?:- )?(?:uses|image): (.*)$/gm)].map(([, what = '']) => what);
    expect(used.length).toBeGreaterThan(0);
    for (const what of used) expect(what).toMatch(/^[\w./-]+@[0-9a-f]{40} # v\d|^[\w.:-]+@sha256:[0-9a-f]{64}$/);
    const { scripts } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8')) as { scripts: object };
    for (const [, script = ''] of text.matchAll(/npm run ([\w:]+)/g)) expect(Object.keys(scripts)).toContain(script);
  });
});

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

describe('comments', () => {
  it('are found where they pass 120 columns, but code, and an address that fills its line, are not', () => {
    const long = 'word '.repeat(24);
    const lines = [
      '// short',
      `  // ${long}`,
      ` * ${long}`,
      `const text = '${long}';`,
      `// https://${'a'.repeat(120)}`,
    ];
    expect(longComments(lines.join('\n'))).toEqual([2, 3]);
  });
});

describe('the order of the page', () => {
  it.each([
    ['a feature that looks up', 'bench/stand.ts', '../shell/header.js', 'app/bench may not use app/shell'],
    ['a component that looks for its models', 'bench/panel.tsx', '../models.js', 'app/bench may not use app/app'],
    ['a feature that knows another', 'memories/copy.ts', '../bench/stand.js', 'app/memories may not use app/bench'],
    ['what lies below and looks up', 'editing/units.ts', '../work/session.js', 'app/editing may not use app/work'],
    ['a timer that knows what is kept', 'timer/link.ts', '../records/library.js', 'app/timer may not use app/records'],
    [
      'a folder in a folder',
      'timeline/preview/player.ts',
      '../../program/presets.js',
      'app/timeline may not use app/program',
    ],
    [
      'a folder without a place',
      'parts/header.tsx',
      '../ui/modal.js',
      'the folder parts is not in the order of the page',
    ],
    ['a room past its door', 'timer/link.ts', '../../serial/ports.js', 'a room is entered through its index.js'],
    ['the simulator', 'timer/link.ts', '../../simulator/index.js', 'only connect/simulated-timer.ts may'],
  ])('refuses %s', (_, file, path, why) => {
    expect(breaches(file, `import { a } from '${path}';`)).toEqual([expect.stringContaining(why)]);
    expect(breaches(file, `const a = await import('${path}');`)).toEqual([expect.stringContaining(why)]);
  });

  it.each(['session.notice.value = null', 'model.front.value++', 'model.count.value += 2'])(
    'refuses a component that writes a signal of a model: %s',
    (line) => {
      expect(breaches('bench/panel.tsx', line)).toEqual([expect.stringContaining('bench/panel.tsx writes ')]);
      expect(breaches('bench/bench.ts', line)).toEqual([]);
    },
  );

  it.each([
    ['knowledge.of(0)', 'standings'],
    ['session.knowledge.of(memory)', 'standings'],
    ['recognition.model.value', 'origin'],
    ['const { model, tells } = this.#session.recognition;', 'origin'],
    ['const { model } = session.recognition;', 'origin'],
  ])('refuses to ask the sources of an answer: %s', (line, answer) => {
    expect(breaches('print/print.ts', line)).toEqual([expect.stringContaining(`ask session.${answer}`)]);
    expect(breaches('work/origin.ts', line)).toEqual([]);
  });

  it('lets a component write its own signals, and compare', () => {
    expect(breaches('bench/panel.tsx', 'open.value = true; if (a.b.value === 1) {}')).toEqual([]);
  });

  it('lets imports run down', () => {
    expect(breaches('program/table.tsx', "import { a } from '../ui/modal.js';")).toEqual([]);
    expect(breaches('program/table.tsx', "import '../bench/b.js';")).toEqual([]);
    expect(breaches('connect/simulated-timer.ts', "import { a } from '../../simulator/index.js';")).toEqual([]);
    expect(breaches('timeline/preview/player.ts', "import { a } from '../scale.js';")).toEqual([]);
  });
});

describe('the styles of the page', () => {
  it('are as they have to be', () => {
    expect(flawsOfPage()).toEqual([]);
  });

  it.each([
    ['a colour in hexadecimal', 'border: 1px solid #a51717'],
    ['a colour as a function', 'background: rgb(8 14 20 / 60%)'],
    ['a colour by name', 'color: white'],
    ['a fifth size of type', 'font-size: 0.9rem'],
    ['a size of type of this window', 'font-size: clamp(1rem, 2vw, 2rem)'],
    ['a step beside the scale of space', 'margin-inline: 0.6rem auto'],
  ])('refuse %s outside of the tokens', (_, declaration) => {
    const text = `/* #fff */\n.a:hover {\n  ${declaration};\n}\n`;
    expect(flaws('line/a.css', text)).toEqual([expect.stringContaining('stands in ui/tokens.css')]);
    expect(flaws('ui/tokens.css', text)).toEqual([]);
  });

  it('take what is in the tokens', () => {
    const text = '.a {\n  padding: 0 var(--space-2);\n  font-size: var(--type-small);\n  color: var(--ink);\n}\n';
    expect(flaws('line/a.css', text)).toEqual([]);
  });

  it('do not look through the whole table for a part of it', () => {
    const text =
      '.a:has(> :not(.b)):focus input {\n  top: 0;\n}\n\n.d :has(svg):hover,\nth:has([open]) {\n  top: 0;\n}\n';
    const found = ['program/a.css: .a:has(> :not(.b)):focus input: styles more than what a key changes'];
    expect([dearSelectors('program/a.css', text), dearSelectors('print/a.css', text)]).toEqual([found, []]);
  });

  it('know few shapes of the window', () => {
    const text = (condition: string) => `${condition} {\n  .a {\n    margin: 0;\n  }\n}\n`;
    for (const condition of [
      '@media (--phone), (--side)',
      '@media (--laptop) and (pointer: fine)',
      '@media print',
      '@container program-table (max-width: 480px)',
    ]) {
      expect(strayThresholds('line/a.css', text(condition))).toEqual([]);
    }
    for (const condition of [
      '@media (max-width: 47.5em)',
      '@media (--phone) and (height < 40em)',
      '@media (--phone), (--small)',
      '@container program-table (width < 480px)',
      '@container program-table (max-width: 530px)',
    ]) {
      expect(strayThresholds('line/a.css', text(condition))).toEqual([
        expect.stringContaining('no shape of the window'),
      ]);
    }
  });

  it('have no class that no component uses', () => {
    const texts = new Map([['line/a.css', '.a:has(.b) .on-a4,\n.gone {\n  margin: 0;\n}\n']]);
    expect(deadClasses(texts, '<p class={`a b on-$'.concat('{paper}`} />'))).toEqual([
      'line/a.css: .gone: no component uses it',
    ]);
  });

  it('give a class one home', () => {
    const texts = new Map([
      ['ui/modal.css', '.dialog > .buttons {\n  margin: 0;\n}\n'],
      [
        'line/a.css',
        '@media print {\n  .a, dialog:has(.b, .c) .dialog {\n    margin: 0;\n  }\n\n  .dialog {\n    margin: 0;\n  }\n}\n',
      ],
    ]);
    expect(strayClasses(texts)).toEqual(['line/a.css: .dialog has its home in ui/modal.css']);
  });
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
