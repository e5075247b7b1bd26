import { defineConfig } from 'vite';

/**
 * Builds the mock port as one classic script, for tools that can put nothing else into a page. A part of `npm run
 * build:lib`.
 */
export default defineConfig({
  publicDir: false,
  build: {
    outDir: 'dist/lib',
    emptyOutDir: false,
    target: 'es2022',
    minify: false,
    lib: {
      entry: 'src/mock-serial/global.ts',
      formats: ['iife'],
      name: 'SidusMockSerial',
      fileName: () => 'mock-serial.global.js',
    },
  },
});
