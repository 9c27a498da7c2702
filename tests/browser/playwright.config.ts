import { join } from 'node:path'
import { defineConfig } from '@playwright/test'
import { chromium } from './chromium'

// Playwright loads these files as CommonJS: __dirname, not import.meta.
const www = join(__dirname, '../../www')
const port = Number(process.env.FORMICARIUM_TEST_PORT ?? 4517)
const subPath = '/lab/formicarium/'

const site = (port: number, base: string) => ({
  url: `http://localhost:${port}${base}`,
  command: `node node_modules/vite/bin/vite.js preview --strictPort --port ${port} --base ${base}`,
  cwd: www,
})
export const atRoot = site(port, '/')
const atSubPath = site(port + 1, subPath)

/** Specs run on the desktop; the tags @phone and @subpath send one elsewhere instead. */
export default defineConfig({
  testDir: '.',
  testIgnore: 'other/**',
  outputDir: '../../target/browser-tests',
  reporter: 'list',
  // A page waits as often as it computes; more pages at once would only wait for each other.
  workers: 2,
  retries: 0,
  // Generous, because machines that run tests are often busy.
  timeout: 90_000,
  expect: { timeout: 15_000 },
  forbidOnly: Boolean(process.env.CI),
  use: {
    browserName: 'chromium',
    launchOptions: chromium,
    trace: 'off',
    // The copy that the page makes of itself is tested by offline.spec.ts alone.
    serviceWorkers: 'block',
  },
  projects: [
    {
      name: 'desktop',
      grepInvert: /@phone|@subpath/,
      use: { baseURL: atRoot.url, viewport: { width: 1440, height: 900 } },
    },
    {
      name: 'phone',
      grep: /@phone/,
      use: {
        baseURL: atRoot.url,
        viewport: { width: 390, height: 844 },
        deviceScaleFactor: 3,
        isMobile: true,
        hasTouch: true,
      },
    },
    {
      name: 'subpath',
      grep: /@subpath/,
      use: { baseURL: atSubPath.url, viewport: { width: 1440, height: 900 } },
    },
  ],
  webServer: [atRoot, atSubPath],
})
