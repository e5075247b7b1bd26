import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, renameSync, symlinkSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { env, platform } from 'node:process';
import { setTimeout } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { build, type Rolldown } from 'vite';
import { inject } from 'vitest';

declare module 'vitest' {
  interface ProvidedContext {
    /** Made by pack-folder.js. */
    packFolder: string;
  }
}

/** Where the project lies. */
export const root = fileURLToPath(new URL('../..', import.meta.url));
/** What a copy of the project can do without. */
const LEFT_OUT = new Set(['.git', 'node_modules', 'dist', 'coverage']);
/** Milliseconds that packing may take on a slow machine. */
const LONGEST = 600_000;

/**
 * The package as npm unpacks it, packed once in a run of tests, whoever asks first. It is packed from a copy: packing
 * builds anew, and would take dist/ away from under the other tests.
 * @returns its folder, which is `node_modules/sidus-timer` of a folder that consumers may lie in.
 */
export async function packed(): Promise<string> {
  const folder = inject('packFolder');
  const home = join(folder, 'node_modules', 'sidus-timer');
  try {
    mkdirSync(join(folder, 'copy'));
  } catch {
    // Another test file is packing it.
    const failed = (): boolean => existsSync(join(folder, 'failed'));
    for (let waited = 0; !existsSync(home); waited += 100) {
      if (waited > LONGEST || failed()) throw new Error('The package could not be packed.');
      await setTimeout(100);
    }
    return home;
  }
  try {
    pack(folder);
    renameSync(join(folder, 'package'), home);
  } catch (error) {
    writeFileSync(join(folder, 'failed'), '');
    throw error;
  }
  return home;
}

function pack(folder: string): void {
  const copy = join(folder, 'copy');
  cpSync(root, copy, { recursive: true, filter: (path) => !LEFT_OUT.has(basename(path)) });
  symlinkSync(join(root, 'node_modules'), join(copy, 'node_modules'), 'junction');
  const said = execFileSync('npm', ['pack', '--json', '--pack-destination', folder], {
    cwd: copy,
    encoding: 'utf8',
    env: { ...env, NODE_ENV: 'production' },
    stdio: ['ignore', 'pipe', 'pipe'],
    shell: platform === 'win32', // There npm is no program but a script.
  });
  const [{ filename }] = JSON.parse(said) as [{ filename: string }];
  execFileSync('tar', ['xzf', filename], { cwd: folder });
  mkdirSync(join(folder, 'node_modules'));
}

/** Somebody else's program, in its own folder, that has installed the package and nothing else. */
export class Consumer {
  readonly folder: string;
  /** Further variables in the environment of its commands. */
  env: Readonly<Record<string, string>> = {};

  private constructor(folder: string) {
    this.folder = folder;
  }

  static async create(): Promise<Consumer> {
    await packed();
    const consumer = new Consumer(mkdtempSync(join(inject('packFolder'), 'consumer-')));
    consumer.write('package.json', '{ "type": "module" }');
    return consumer;
  }

  write(file: string, text: string): void {
    writeFileSync(join(this.folder, file), text);
  }

  /** Lets it use a package, or a scope of packages, that this project has. */
  link(name: string): void {
    mkdirSync(join(this.folder, 'node_modules'), { recursive: true });
    symlinkSync(join(root, 'node_modules', name), join(this.folder, 'node_modules', name), 'junction');
  }

  /** @returns what the command prints. */
  run(command: string, ...args: string[]): string {
    return execFileSync(command, args, { cwd: this.folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
  }

  /** Runs a command that may fail. */
  tell(command: string, ...args: string[]): { code: number | null; said: string; complained: string } {
    const { status, stdout, stderr } = spawnSync(command, args, {
      cwd: this.folder,
      encoding: 'utf8',
      env: { ...env, ...this.env },
    });
    return { code: status, said: stdout, complained: stderr };
  }

  /** Bundles a module as one classic script. @returns its text, which puts what the module exports under `sidus`. */
  async classicScript(main: string): Promise<string> {
    this.write('main.js', main);
    const [built] = (await build({
      configFile: false,
      root: this.folder,
      logLevel: 'error',
      build: { write: false, target: 'es2022', lib: { entry: 'main.js', formats: ['iife'], name: 'sidus' } },
    })) as Rolldown.RolldownOutput[];
    return built?.output[0].code ?? '';
  }

  /** Runs the compiler of this project in the folder, as strict as possible. @returns its complaints. */
  compile(options: object = {}): string {
    const compilerOptions = {
      strict: true,
      exactOptionalPropertyTypes: true,
      noEmit: true,
      skipLibCheck: false,
      module: 'nodenext',
      target: 'es2022',
      lib: ['es2022', 'dom'],
      types: [],
      ...options,
    };
    this.write('tsconfig.json', JSON.stringify({ compilerOptions }));
    return this.tell(process.execPath, join(root, 'node_modules/typescript/bin/tsc'), '-p', '.').said;
  }
}
