import { fileURLToPath } from 'node:url';
import { build } from 'vite';

/**
 * The script that puts a workbench in place of the browser's serial ports, with everything that it imports, to run in a
 * page.
 */
export async function workbenchScript() {
  const entry = fileURLToPath(new URL('../site/workbench.ts', import.meta.url));
  const built = await build({
    configFile: false,
    logLevel: 'warn',
    build: { write: false, target: 'es2022', lib: { entry, formats: ['iife'], name: 'script' } },
  });
  const [output] = [built].flat();
  if (!output || !('output' in output)) throw new Error('The workbench was not built.');
  return output.output[0].code;
}
