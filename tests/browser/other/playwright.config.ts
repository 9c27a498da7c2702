import { defineConfig } from '@playwright/test'
import base, { atRoot } from '../playwright.config'
import type { Choice } from './browsers'

/** The page in Firefox and WebKitGTK as they are installed; a project tells what draws there. */
export default defineConfig<Choice>({
  ...base,
  testIgnore: [],
  // One screen for all.
  workers: 1,
  outputDir: '../../../target/other-browser-tests',
  // A screen without a graphics card is slow, and every check starts a browser.
  timeout: 240_000,
  expect: { timeout: 60_000, toPass: { timeout: 60_000 } },
  projects: [
    { name: 'firefox-touch', use: { baseURL: atRoot.url, browserOf: 'firefox' } },
    { name: 'webkit-pen', use: { baseURL: atRoot.url, browserOf: 'webkit' } },
  ],
  webServer: [atRoot],
})
