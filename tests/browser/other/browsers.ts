/** The test of each check here: with the browser of its project, started anew for it. */
import { test as base } from '@playwright/test'
import { Firefox } from './firefox'
import type { OtherBrowser } from './other_browser'
import { WebKit } from './webkit'

/** What a project says. */
export interface Choice {
  browserOf: 'firefox' | 'webkit'
}

const start = {
  firefox: (site: string) => Firefox.start(process.env.FIREFOX_PATH ?? '/usr/bin/firefox', site),
  webkit: (site: string, folder: string) =>
    WebKit.start(process.env.WEBKIT_DRIVER ?? '/usr/bin/WebKitWebDriver', site, folder),
}

export const test = base.extend<Choice & { other: OtherBrowser }>({
  browserOf: ['firefox', { option: true }],
  other: async ({ browserOf, baseURL }, use, info) => {
    const other = await start[browserOf](baseURL ?? '', info.outputPath('settings'))
    await use(other)
    await other.close()
  },
})
