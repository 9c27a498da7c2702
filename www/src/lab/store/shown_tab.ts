/** The tab of the results that the reader chose; null: the first one. */
import { signal } from '@preact/signals'

export const shownTab = signal<string | null>(null)
