import { defineConfig } from 'vitest/config';

// Without a config of its own Vitest would take that of a project in a folder above.
// biome-ignore lint/style/noDefaultExport: Vitest asks for one.
export default defineConfig({ test: { include: ['*.test.js'] } });
