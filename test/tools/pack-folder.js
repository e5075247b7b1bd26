import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/**
 * A folder for one run of tests. pack.ts packs the package into it when a test first needs it.
 * @param {{ provide: (name: string, value: unknown) => void }} project
 */
export function setup({ provide }) {
  const folder = mkdtempSync(join(tmpdir(), 'sidus-pack-'));
  provide('packFolder', folder);
  return () => rmSync(folder, { recursive: true, force: true });
}
