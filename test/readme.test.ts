import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';

const root = fileURLToPath(new URL('..', import.meta.url));
const readme = readFileSync(join(root, 'README.md'), 'utf8');
/** The examples of the README, in their order. */
const examples = [...readme.matchAll(/```ts\n(.*?)```/gs)].map(([, code]) => code as string);

let folder: string;
const run = (command: string, ...args: string[]): string =>
  execFileSync(command, args, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/** A program of somebody else's in an empty folder, with the package as npm would unpack it. */
beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), 'sidus-readme-'));
  const [pack] = JSON.parse(
    execFileSync('npm', ['pack', '--json', '--pack-destination', folder], { cwd: root, encoding: 'utf8' }),
  ) as { filename: string }[];
  run('tar', 'xzf', (pack as { filename: string }).filename);
  mkdirSync(join(folder, 'node_modules'));
  cpSync(join(folder, 'package'), join(folder, 'node_modules/sidus-timer'), { recursive: true });
  writeFileSync(join(folder, 'package.json'), '{ "type": "module" }');
}, 120_000);

afterAll(() => rmSync(folder, { recursive: true, force: true }));

describe('the packed package', () => {
  it('holds what it declares and nothing of the app', () => {
    const { exports } = JSON.parse(readFileSync(join(folder, 'package/package.json'), 'utf8')) as {
      exports: Record<string, { types: string; default: string }>;
    };
    for (const { types, default: code } of Object.values(exports)) {
      expect(existsSync(join(folder, 'package', types)), types).toBe(true);
      expect(existsSync(join(folder, 'package', code)), code).toBe(true);
    }
    expect(existsSync(join(folder, 'package/LICENSE'))).toBe(true);
    expect(existsSync(join(folder, 'package/src/app'))).toBe(false);
    expect(existsSync(join(folder, 'package/dist/site'))).toBe(false);
  });

  it('gives encodeFrame and FrameDecoder to a script in Node', () => {
    const script = `import { encodeFrame, FrameDecoder } from 'sidus-timer/protocol';
      console.log(Buffer.from(encodeFrame(0x6b)).toString('hex'), new FrameDecoder().push(encodeFrame(0x72, [3])).length);`;
    expect(run(process.execPath, '--input-type=module', '--eval', script).trim()).toBe('0000000000036b6b45 1');
  });

  it('compiles for a strict consumer that has only the DOM library', () => {
    examples.forEach((code, index) => {
      writeFileSync(join(folder, `example-${index}.ts`), code);
    });
    const options = {
      strict: true,
      noEmit: true,
      skipLibCheck: false,
      module: 'nodenext',
      target: 'es2022',
      types: [],
    };
    const compilerOptions = { ...options, lib: ['es2022', 'dom'], exactOptionalPropertyTypes: true };
    writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify({ compilerOptions, include: ['*.ts'] }));
    const tsc = join(root, 'node_modules/typescript/bin/tsc');
    expect(run(process.execPath, tsc, '-p', '.')).toBe('');
  }, 60_000);
});

describe('the examples of the README', () => {
  it('are two, and do what their comments say', () => {
    expect(examples).toHaveLength(2);
    examples.forEach((code, index) => {
      writeFileSync(join(folder, `example-${index}.js`), code);
    });
    run(process.execPath, 'example-0.js');
    const said = [...(examples[1] as string).matchAll(/console\.log\(.*\/\/ (.*)/g)].map(([, comment]) => comment);
    expect(run(process.execPath, 'example-1.js').trim().split('\n')).toEqual(said);
  });

  it('show the frames that the package makes', () => {
    const [first] = examples as [string];
    const shown = /Uint8Array ((?:[0-9a-f]{2} )+[0-9a-f]{2})/.exec(first)?.[1];
    const script = `import { encodeFrame } from 'sidus-timer/protocol'; console.log(Buffer.from(encodeFrame(0x6b)).toString('hex'));`;
    expect(run(process.execPath, '--input-type=module', '--eval', script).trim()).toBe(shown?.replaceAll(' ', ''));
  });
});
