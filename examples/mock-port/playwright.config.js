import process from 'node:process';
import { defineConfig } from '@playwright/test';

/** A Chrome or Chromium of one's own, where Playwright has not installed one. */
const executablePath = process.env.CHROME_PATH;

// biome-ignore lint/style/noDefaultExport: Playwright asks for one.
export default defineConfig({
  testMatch: '*.spec.js',
  use: {
    baseURL: 'http://127.0.0.1:5199/',
    launchOptions: executablePath ? { executablePath, args: process.getuid?.() === 0 ? ['--no-sandbox'] : [] } : {},
  },
  webServer: {
    command: 'vite --host 127.0.0.1 --port 5199 --strictPort',
    url: 'http://127.0.0.1:5199/thermometer.html',
  },
});
