import { defineConfig } from '@playwright/test'
export default defineConfig({
  testDir: '/work/main/tests/browser', outputDir: '/tmp/ui/pw-out', reporter: 'line', workers: 1, timeout: 90000, expect: { timeout: 15000 },
  use: { browserName: 'chromium', baseURL: 'http://localhost:5222/', launchOptions: { executablePath: '/usr/bin/chromium' }, trace: 'off' },
  projects: [
    { name: 'desktop', grepInvert: /@phone|@subpath/, use: { viewport: { width: 1440, height: 900 } } },
    { name: 'phone', grep: /@phone/, use: { viewport: { width: 390, height: 844 }, deviceScaleFactor: 3, isMobile: true, hasTouch: true } },
  ],
})
