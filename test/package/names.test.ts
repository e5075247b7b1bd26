import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { env } from 'node:process';
import { describe, expect, it } from 'vitest';
import { packed, root } from '../tools/pack.js';

/*
 * What programs of others rest on: the names of the package and the codes of its errors. A change of either is a
 * decision, and its line stands in the changelog. `NAMES=keep npx vitest run --project unit test/package/names.test.ts`
 * keeps the names as they are now, when a version is released.
 */

const KEPT = join(root, 'test/package/names.json');
type Names = Readonly<Record<string, readonly string[]>>;

/** The names of each entry, types too, and the codes of the error classes, as the declarations have them. */
async function present(): Promise<Names> {
  const home = await packed();
  const { exports } = JSON.parse(readFileSync(join(home, 'package.json'), 'utf8')) as {
    exports: Record<string, string | { types: string }>;
  };
  const read = (file: string): string => readFileSync(join(home, 'dist/lib', file), 'utf8');
  const entries = Object.entries(exports).flatMap(([entry, files]) =>
    typeof files === 'string' || entry.endsWith('.js') ? [] : [[entry, namesIn(read(files.types.slice(11)))] as const],
  );
  const codes = [
    ['protocol/errors.d.ts', 'CodecErrorCode'],
    ['client/errors.d.ts', 'TimerErrorCode'],
    ['serial/errors.d.ts', 'ConnectionErrorCode'],
  ].map(([file = '', type = '']) => [type, codesOf(read(file), type)] as const);
  return Object.fromEntries([...entries, ...codes]);
}

function namesIn(declarations: string): string[] {
  const lists = [...declarations.matchAll(/export (?:type )?\{([^}]*)\} from '([^']+)'/g)];
  const all = [...declarations.matchAll(/export \* from '([^']+)'/g)].map(([, from]) => `all of ${from}`);
  const named = lists.flatMap(([, list = '']) => list.split(',').map((name) => name.replace('type ', '').trim()));
  return [...new Set([...all, ...named.filter(Boolean)])].sort();
}

function codesOf(declarations: string, type: string): string[] {
  const [, union = ''] = new RegExp(`type ${type} = ([^;]+);`).exec(declarations) ?? [];
  return [...union.matchAll(/'([^']+)'/g)].map(([, code = '']) => code).sort();
}

describe('the public names and the codes of errors', () => {
  it('are as they were released, but for what the changelog says under its first heading', async () => {
    const now = await present();
    const { NAMES } = env;
    if (NAMES === 'keep') writeFileSync(KEPT, `${JSON.stringify(now, null, 2)}\n`);
    const before = JSON.parse(readFileSync(KEPT, 'utf8')) as Names;
    const [, latest = ''] = readFileSync(join(root, 'CHANGELOG.md'), 'utf8').split(/^## /m);
    for (const entry of new Set([...Object.keys(before), ...Object.keys(now)])) {
      const [was, is] = [before[entry] ?? [], now[entry] ?? []];
      const changed = [...was.filter((name) => !is.includes(name)), ...is.filter((name) => !was.includes(name))];
      for (const name of changed)
        expect(
          latest,
          `${name} of ${entry} has changed, and the changelog does not say so under its first heading`,
        ).toContain(`\`${name}`);
    }
  });

  it('are found: an empty list would prove nothing', async () => {
    const now = new Map(Object.entries(await present()));
    for (const [entry, names] of now) expect(names.length, `${entry} has names`).toBeGreaterThan(1);
    expect(now.get('./protocol')).toContain('FrameDecoder');
    expect(now.get('TimerErrorCode')).toContain('no-answer');
  });
});
