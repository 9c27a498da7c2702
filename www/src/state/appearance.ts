/** Theme, language and motion: what the reader chose, or what the system prefers. */
import { computed, effect, signal } from '@preact/signals'
import { type Language, useLanguage } from '../i18n'
import { canKeep } from '../model/storage'
import { embedding } from './embedding'

export type ThemeChoice = 'system' | 'light' | 'dark'

const THEME_KEY = 'formicarium.theme'
const LANGUAGE_KEY = 'formicarium.language'
const darkQuery = matchMedia('(prefers-color-scheme: dark)')
const systemDark = signal(darkQuery.matches)
darkQuery.addEventListener('change', (event) => {
  systemDark.value = event.matches
})

export const themeChoice = signal<ThemeChoice>(remembered())
export const theme = computed<'light' | 'dark'>(() => {
  if (themeChoice.value !== 'system') return themeChoice.value
  return systemDark.value ? 'dark' : 'light'
})

export function setTheme(choice: ThemeChoice): void {
  themeChoice.value = choice
  // Nothing stored means: as the system.
  remember(THEME_KEY, choice === 'system' ? '' : choice)
}

/** The language of an earlier visit. */
export const rememberedLanguage = () => recall(LANGUAGE_KEY)

export async function setLanguage(choice: Language): Promise<void> {
  await useLanguage(choice)
  remember(LANGUAGE_KEY, choice)
}

export const reducedMotion = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches

/** Private windows may refuse storage; the choice then lasts as long as the page. */
export function remember(key: string, value: string): void {
  if (!canKeep()) return
  try {
    localStorage.setItem(key, value)
  } catch {}
}

export function recall(key: string): string | null {
  if (!canKeep()) return null
  try {
    return localStorage.getItem(key)
  } catch {
    return null
  }
}

function remembered(): ThemeChoice {
  const value = embedding ? embedding.get('theme') : recall(THEME_KEY)
  return value === 'light' || value === 'dark' ? value : 'system'
}

effect(() => {
  document.documentElement.dataset.theme = theme.value
})
