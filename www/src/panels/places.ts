/** Where things about a panel stand on the page, and the way to them. */
import { openColumn, selectedPanel, soughtPart } from '../state'

export const cardId = (panelId: number) => `panel-${panelId}`

/** Selects a panel and brings its parameters into sight. */
export function showParameters(panelId: number): void {
  selectedPanel.value = panelId
  openColumn(true)
  soughtPart.value = 'parameters'
}
