import { readdirSync, readFileSync } from 'node:fs';
import { join, sep } from 'node:path';
import { createContext, Script } from 'node:vm';
import { parseAst } from 'vite';
import { beforeAll, describe, expect, it } from 'vitest';
import type { MockSerial } from '../../src/mock-serial/index.js';
import { Consumer, packed } from '../tools/pack.js';

/** A node of a syntax tree, as far as it matters here. */
interface SyntaxNode {
  readonly type: string;
  readonly name?: string;
  readonly computed?: boolean;
  readonly source?: { readonly value?: unknown } | null;
}

/** What Node has and the web has not. (`setImmediate` is looked for as a property of globalThis, and done without.) */
const NODE_GLOBALS = new Set([
  '__dirname',
  '__filename',
  'Buffer',
  'exports',
  'global',
  'module',
  'process',
  'require',
]);

let home: string;
let modules: [path: string, code: string][];
beforeAll(async () => {
  home = await packed();
  const lib = join(home, 'dist', 'lib');
  modules = readdirSync(lib, { recursive: true, encoding: 'utf8' })
    .filter((path) => path.endsWith('.js'))
    .map((path) => [path.split(sep).join('/'), readFileSync(join(lib, path), 'utf8')]);
});

/**
 * What a module imports, and which names of Node it uses. A name after a dot, before a colon, or that the module itself
 * declares, does not count.
 */
function uses(code: string): { imports: string[]; globals: string[] } {
  const imports: string[] = [];
  const globals: string[] = [];
  const own = new Set<string>();
  const walk = (node: SyntaxNode, isLabel = false): void => {
    const { type, name = '', source, computed = false } = node;
    if (/^(Import|Export)/.test(type) && source) imports.push(String(source.value));
    if (type === 'Identifier' && !isLabel && NODE_GLOBALS.has(name)) globals.push(name);
    for (const [part, child] of Object.entries(node)) {
      for (const inner of [child].flat()) {
        if (!inner || typeof inner !== 'object' || !('type' in inner)) continue;
        if (part === 'id' || part === 'params' || part === 'local') own.add((inner as SyntaxNode).name ?? '');
        walk(inner as SyntaxNode, (part === 'property' || part === 'key') && !computed);
      }
    }
  };
  walk(parseAst(code) as unknown as SyntaxNode);
  return { imports, globals: globals.filter((name) => !own.has(name)) };
}

describe('the package uses web standards only', () => {
  it('notices code that uses more than that', () => {
    const code = `import fs from 'node:fs'; export * from './a.js'; const b = await import('x'); process.exit(a.process, { Buffer: 1 }); const require = 1; require;`;
    expect(uses(code)).toEqual({ imports: ['node:fs', './a.js', 'x'], globals: ['process'] });
  });

  it('imports nothing but its own modules', () => {
    expect(modules.length).toBeGreaterThan(20);
    for (const [path, code] of modules) {
      for (const specifier of uses(code).imports) expect(specifier, `what ${path} imports`).toMatch(/^\.\.?\/.*\.js$/);
    }
  });

  it('uses no name that only Node has', () => {
    for (const [path, code] of modules) expect(uses(code).globals, `names that only Node has, in ${path}`).toEqual([]);
  });
});

/** The globals that browsers, Deno, Bun and Node share, as far as the package asks for them. */
const web = () => ({
  AbortController,
  ByteLengthQueuingStrategy,
  clearTimeout,
  DOMException,
  Event,
  EventTarget,
  MessageChannel,
  performance,
  queueMicrotask,
  ReadableStream,
  setTimeout,
  Uint8Array,
  WritableStream,
});

describe('the pack', () => {
  it('holds each module once, without a map, and the page to which its README leads', () => {
    const files = readdirSync(home, { recursive: true }).map((path) => String(path).split(sep).join('/'));
    expect(files.filter((path) => /^src|\.map$|\.ts$(?<!\.d\.ts)/.test(path))).toEqual([]);
    expect(modules.filter(([, code]) => code.includes('sourceMappingURL'))).toEqual([]);
    expect(files).toContain('docs/package.md');
  });
});

describe('where there is nothing but the web', () => {
  it('a client reads, writes and verifies', async () => {
    const consumer = await Consumer.create();
    const script = await consumer.classicScript(
      `export * from 'sidus-timer/client'; export * from 'sidus-timer/simulator';`,
    );
    const world = createContext(web());
    new Script(script).runInContext(world);
    const result = new Script(`(async () => {
      const timer = new sidus.TimerClient(new sidus.VirtualTimer());
      const program = await timer.readProgram();
      const report = await timer.writeProgram({ ...program, times: program.times.map((time) => time + 1) }, { baseline: program });
      await timer.close();
      return report.result;
    })()`).runInContext(world);
    expect(await result).toBe('verified');
  });

  it('a classic script gives a page the mock port', async () => {
    const script = new Script(readFileSync(join(home, 'dist/lib/mock-serial.global.js'), 'utf8'));
    const page: ReturnType<typeof web> & { SidusMockSerial?: { MockSerial: typeof MockSerial } } = web();
    script.runInContext(createContext(page));
    const { MockSerial: Mock } = page.SidusMockSerial ?? {};
    if (!Mock) throw new Error('the script has set no global');
    const serial = new Mock({ userActivation: true });
    const port = serial.plug({ usbVendorId: 0x0403, usbProductId: 0x6001 });
    serial.choose(port);
    expect(await serial.requestPort()).toBe(port);
    await port.open({ baudRate: 9600 });
    port.device.write([1, 2, 3]);
    const reader = port.readable?.getReader();
    expect([...((await reader?.read())?.value ?? [])]).toEqual([1, 2, 3]);
  });
});
