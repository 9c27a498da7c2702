/**
 * uPlot formats numbers in the language that the browser names, and cannot even be loaded where that name is no language tag ("C",
 * "en-US@posix"). Here it takes the page's language, as every other number on the page does.
 */
import type { Plugin } from 'vite'

const BROWSERS = "domEnv ? nav.language : 'en-US'"
const PAGES = "document.documentElement.lang || 'en'"

export function chartNumbers(): Plugin {
  return {
    name: 'formicarium:chart-numbers',
    // As it is, rather than put together beforehand, where no plugin would see it.
    config: () => ({ optimizeDeps: { exclude: ['uplot'] } }),
    transform(code, id) {
      if (!id.endsWith('uPlot.esm.js')) return undefined
      if (!code.includes(BROWSERS))
        this.error(`uPlot no longer says ${BROWSERS}: see ${import.meta.filename}`)
      return { code: code.replace(BROWSERS, PAGES), map: null }
    },
  }
}
