/**
 * What figures look like. They leave the page, where no style sheet follows them: so their colours are written here, the same as
 * styles/tokens.css has for the two themes.
 */
import type { SymbolName } from './point_symbols'

export type Ground = 'light' | 'dark'

export interface Look {
  background: string
  text: string
  muted: string
  line: string
  bad: string
}

export const LOOKS: Record<Ground, Look> = {
  light: {
    background: '#ffffff',
    text: '#14211d',
    muted: '#53625c',
    line: '#dde3e0',
    bad: '#a3271b',
  },
  dark: {
    background: '#141c1a',
    text: '#e6eeea',
    muted: '#98a8a1',
    line: '#2f3d3a',
    bad: '#ff9b8f',
  },
}

export const FONT =
  '"Figtree Variable", Inter, "Segoe UI", system-ui, Roboto, "PingFang SC", "Microsoft YaHei", "Noto Sans SC", "Noto Sans CJK SC", "Source Han Sans SC", sans-serif'

/** How one entry is told from the others: by colour, by dashes and by symbol, each of which is enough alone. */
export interface Series {
  label: string
  colour: string
  /** `stroke-dasharray`; none for a whole line. */
  dash: string | undefined
  symbol: SymbolName
}
