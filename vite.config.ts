import { readFileSync } from 'node:fs';
import preact from '@preact/preset-vite';
import { defineConfig, type Plugin } from 'vite';
import { VitePWA } from 'vite-plugin-pwa';

/** All that the built page may do: run its own scripts, styles and pictures. It can reach no address on any network. */
const contentSecurityPolicy = [
  "default-src 'none'",
  "script-src 'self'",
  "style-src 'self'",
  "img-src 'self'",
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

const offline = VitePWA({
  // A new version waits until the pilot takes it: src/app/offline.ts.
  registerType: 'prompt',
  injectRegister: false,
  includeManifestIcons: false,
  manifest: {
    name: 'Sidus Timer',
    short_name: 'Sidus Timer',
    description: 'Reads, edits and writes the program of a Sidus free-flight timer. Works offline.',
    lang: 'en',
    start_url: './',
    scope: './',
    display: 'standalone',
    theme_color: '#10171e',
    background_color: '#10171e',
    categories: ['utilities', 'sports'],
    icons: [
      { src: 'favicon.svg', sizes: 'any', type: 'image/svg+xml' },
      { src: 'icon-192.png', sizes: '192x192', type: 'image/png' },
      { src: 'icon-512.png', sizes: '512x512', type: 'image/png' },
      { src: 'icon-maskable-512.png', sizes: '512x512', type: 'image/png', purpose: 'maskable' },
    ],
  },
  workbox: {
    globPatterns: ['**/*'],
    // The first visit is offline-proof as it stands, without a reload.
    clientsClaim: true,
    // The page has one address, whatever follows its question mark; what else lies below it is not the page.
    navigateFallback: null,
    ignoreURLParametersMatching: [/./],
  },
});

/** Which version the page says it is. */
const { version } = JSON.parse(readFileSync(new URL('package.json', import.meta.url), 'utf8')) as { version: string };

export default defineConfig({
  root: 'src/app',
  publicDir: '../../public',
  // Relative addresses: the same build works at the root of a host and under any sub-path.
  base: './',
  appType: 'mpa',
  define: { 'import.meta.env.VITE_VERSION': JSON.stringify(version) },
  plugins: [preact({ include: [/\.tsx$/] }), securityPolicy, offline],
  build: {
    outDir: '../../dist/site',
    emptyOutDir: true,
    target: 'es2022',
    // A picture inside a style would be a data: address, which the policy above shuts out.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  server: { port: 5173, host: '127.0.0.1' },
  preview: { cors: false },
});
