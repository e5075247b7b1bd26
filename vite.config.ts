import preact from '@preact/preset-vite';
import { defineConfig } from 'vite';

export default defineConfig({
  // Relative addresses: the same build works at the root of a host and under any sub-path.
  base: './',
  plugins: [preact({ include: [/\.tsx$/] })],
  build: { outDir: 'dist/site', emptyOutDir: true, target: 'es2022' },
  server: { port: 5173, host: '127.0.0.1' },
});
