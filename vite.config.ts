import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import preact from '@preact/preset-vite';
import { defineConfig, type Plugin } from 'vite';
import { VitePWA } from 'vite-plugin-pwa';
import { SHAPES } from './src/app/ui/shapes.js';
import { sentences } from './test/tools/catalogue.js';
import { connectionPage } from './test/tools/connection-page.js';
import { licences, ownWorkOnly } from './test/tools/licences.js';

const root = import.meta.dirname;

/** The folder of the built page: dist/site, unless `--outDir` names another. */
let site = '';

const whereBuilt: Plugin = {
  name: 'where-built',
  configResolved: ({ root, build }) => {
    site = resolve(root, build.outDir);
  },
};

/**
 * Everything that the built page may do: run its own scripts, and use its own styles and pictures. It can reach no
 * address on any network.
 */
const contentSecurityPolicy = [
  "default-src 'none'",
  "script-src 'self'",
  "style-src 'self'",
  "img-src 'self'",
  "font-src 'self'",
  "manifest-src 'self'",
  "worker-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
  "require-trusted-types-for 'script'",
  'trusted-types service-worker',
].join('; ');

const securityPolicy: Plugin = {
  name: 'content-security-policy',
  apply: 'build',
  transformIndexHtml: () => [
    {
      tag: 'meta',
      attrs: { 'http-equiv': 'Content-Security-Policy', content: contentSecurityPolicy },
      injectTo: 'head-prepend',
    },
  ],
};

/** Gives the styles the shapes of the window. Browsers do not know `@custom-media` yet. */
const shapes: Plugin = {
  name: 'shapes',
  enforce: 'pre',
  transform: {
    filter: { id: /\.css$/ },
    handler: (text) =>
      text.replace(/@media .*/g, (rule) =>
        rule.replace(/\(--(\w+)\)/g, (_, name: keyof typeof SHAPES) => SHAPES[name]),
      ),
  },
};

/**
 * The start stands in index.html and is drawn before any script runs. test/app/first-picture.test.tsx writes it from
 * the page itself.
 */
const firstPicture: Plugin = {
  name: 'first-picture',
  transformIndexHtml: {
    // Inserted unchanged: its addresses are those of the built page.
    order: 'post',
    handler: (html) =>
      html.replace(
        '<!-- first picture -->',
        readFileSync(new URL('src/app/first-picture.html', import.meta.url), 'utf8').trim(),
      ),
  },
};

/** The letters that every view needs are loaded with the page; those of other languages when they are first used. */
const font: Plugin = {
  name: 'font',
  apply: 'build',
  transformIndexHtml: {
    order: 'post',
    handler: (_, { bundle = {} }) =>
      Object.keys(bundle)
        .filter((file) => LATIN.test(file))
        .map((file) => ({
          tag: 'link',
          attrs: { rel: 'preload', href: `./${file}`, as: 'font', type: 'font/woff2', crossorigin: '' },
          injectTo: 'head',
        })),
  },
};

const LATIN = /inter-latin-wght-normal-[\w-]+\.woff2$/;

/** The checksum of a built file, in the form that browsers check. */
function integrityOf(url: string): string {
  const bytes = readFileSync(resolve(site, url));
  return `sha256-${createHash('sha256').update(bytes).digest('base64')}`;
}

const offline = VitePWA({
  // A new version waits until the pilot accepts it: src/app/browser/offline.ts.
  registerType: 'prompt',
  injectRegister: false,
  // It is in public/. Made here, it would be kept twice, once without its checksum.
  manifest: false,
  // We have our own worker, src/app/sw.ts: it must never be able to stop the page from loading.
  strategies: 'injectManifest',
  srcDir: '.',
  filename: 'sw.ts',
  injectManifest: {
    buildPlugins: { vite: [ownWorkOnly(root)] },
    globPatterns: ['**/*'],
    // The emergency worker for the publisher, and files that the page itself never asks for.
    globIgnores: ['kill-sw.js', 'library.schema.json', '*.png', 'screenshots/*'],
    manifestTransforms: [
      async (entries) => ({
        manifest: entries.map(({ url, size }) => ({
          url,
          size,
          revision: null,
          integrity: integrityOf(url),
          ...(url.endsWith('.woff2') && !LATIN.test(url) ? { later: true } : {}),
        })),
      }),
    ],
  },
});

const textOf = (file: string): string => readFileSync(new URL(file, import.meta.url), 'utf8');

/** The version that the page shows. */
const { version } = JSON.parse(textOf('package.json')) as { version: string };

export default defineConfig(({ mode }) => ({
  root: 'src/app',
  publicDir: '../../public',
  // Relative addresses: the same build works at the root of a host and under any sub-path.
  base: './',
  appType: 'mpa',
  define: {
    'import.meta.env.VITE_VERSION': JSON.stringify(version),
  },
  plugins: [
    preact({ include: [/\.tsx$/] }),
    // Built with `--mode pseudo`, each language but English is one that shows what does not come from en.ftl.
    sentences({ inPseudo: mode === 'pseudo' }),
    shapes,
    whereBuilt,
    firstPicture,
    securityPolicy,
    font,
    licences(root),
    connectionPage(),
    offline,
  ],
  build: {
    outDir: '../../dist/site',
    emptyOutDir: true,
    target: 'es2022',
    // A picture inside a style would be a data: address, which the policy above forbids.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  server: { port: 5173, host: '127.0.0.1' },
  preview: { cors: false },
}));
