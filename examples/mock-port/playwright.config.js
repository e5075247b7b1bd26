import process from 'node:process';
import { defineConfig } from '@playwright/test';

/** Your own Chrome or Chromium, where Playwright has not installed one. */
const executablePath = process.env.CHROME_PATH;

/** The port at which Vite serves the page during the tests. */
const port = process.env.PORT ?? '5199';

// biome-ignore lint/style/noDefaultExport: Playwright asks for one.
export default defineConfig({
  testMatch: '*.spec.js',
  use: {
    baseURL: `http://127.0.0.1:${port}/`,
    launchOptions: executablePath ? { executablePath, args: process.getuid?.() === 0 ? ['--no-sandbox'] : [] } : {},
  },
  webServer: {
    command: `vite --host 127.0.0.1 --port ${port} --strictPort`,
    url: `http://127.0.0.1:${port}/thermometer.html`,
  },
});
