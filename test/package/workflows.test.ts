import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { root } from '../tools/pack.js';

const FOLDER = join(root, '.github/workflows');
const workflows = readdirSync(FOLDER).map((file) => [file, readFileSync(join(FOLDER, file), 'utf8')] as const);
const { scripts } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8')) as { scripts: Record<string, string> };

/** The jobs of a workflow with their lines, by name. */
function jobsOf(text: string): [name: string, body: string][] {
  const [, jobs = ''] = text.split(/^jobs:\n/m);
  const parts = jobs.split(/^ {2}([\w-]+):\n/m).slice(1);
  return parts.flatMap((name, i) => (i % 2 ? [] : [[name, parts[i + 1] ?? ''] as [string, string]]));
}

/** What the steps run: the rest of a line, or the lines below it. */
function commandsOf(text: string): string[] {
  return [...text.matchAll(/^ *(?:- )?run: (?:\|\n((?: {10,}.*\n)+)|(.*))/gm)].map(
    ([, block, line]) => block ?? line ?? '',
  );
}

it('one action has one digest in all workflows', () => {
  const uses = new Set(workflows.flatMap(([, text]) => [...text.matchAll(/uses: (.*)/g)].map(([, use = '']) => use)));
  expect([...uses].map((use) => use.split('@')[0])).toHaveLength(
    new Set([...uses].map((use) => use.split('@')[0])).size,
  );
});

describe.each(workflows)('the workflow %s', (_, text) => {
  it('names every action and container by a digest, and each action with its version', () => {
    const uses = [...text.matchAll(/uses: (.*)/g)].map(([, use]) => use);
    expect(uses.length).toBeGreaterThan(0);
    for (const use of uses) expect(use).toMatch(/^[\w-]+\/[\w/-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+$/);
    for (const [, image] of text.matchAll(/image: (.*)/g)) expect(image).toMatch(/@sha256:[0-9a-f]{64}$/);
  });

  it('runs scripts that exist', () => {
    const commands = commandsOf(text);
    for (const [, script = ''] of commands.join('\n').matchAll(/npm run (?:-\S+ )*([\w:-]+)/g)) {
      expect(Object.keys(scripts)).toContain(script);
    }
    for (const [, file = ''] of commands.join('\n').matchAll(/(?:python3|node) ([\w./-]+\.\w+)/g)) {
      expect(existsSync(join(root, file)), `${file} does not exist`).toBe(true);
    }
  });

  it('may only read, and a job that may do more says so itself', () => {
    expect(text).toMatch(/^permissions:\n {2}contents: read\n\n/m);
    expect(text).not.toMatch(/pull_request_target|workflow_run|write-all/);
    const more = jobsOf(text).flatMap(([name, body]) =>
      [...body.matchAll(/^ +([\w-]+: write)$/gm)].map(([, right]) => `${name} ${right}`),
    );
    const allowed = [
      'publish pages: write',
      'publish id-token: write',
      'release id-token: write',
      'release contents: write',
      'analyze security-events: write',
    ];
    expect(allowed).toEqual(expect.arrayContaining(more));
  });

  it('stops a job that hangs, and waits only for jobs that exist', () => {
    const jobs = jobsOf(text);
    expect(jobs.length).toBeGreaterThan(0);
    for (const [name, body] of jobs) {
      expect(body, `the job ${name} has no time limit`).toMatch(/^ {4}timeout-minutes: \d+$/m);
      const [, needs = ''] = /^ {4}needs: \[?([\w, -]+)\]?$/m.exec(body) ?? [];
      for (const need of needs.split(', ').filter(Boolean)) expect(jobs.map(([each]) => each)).toContain(need);
    }
  });

  it('puts nothing that a stranger can write into a command', () => {
    // A matrix stands in the file itself.
    const given = /\$\{\{ (?!matrix\.)(.*?) \}\}/g;
    for (const command of commandsOf(text)) expect(command).not.toMatch(given);
    for (const [, expression] of text.matchAll(given)) {
      expect(['steps.deployment.outputs.page_url', 'github.token']).toContain(expression);
    }
  });
});
