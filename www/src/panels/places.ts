/** Where things about a panel stand on the page, and the way to them. */
import { seek, selectedPanel } from '../state'

export const cardId = (panelId: number) => `panel-${panelId}`

/** Selects a panel and brings its parameters into sight. */
export function showParameters(panelId: number): void {
  selectedPanel.value = panelId
  seek('parameters')
}
