import { ChartColumn, CircleQuestionMark, Eye, Languages, Monitor, Moon, Share2, Sun } from 'lucide'
import { LANGUAGES, type Language, language, t } from '../i18n'
import { RaceStrip } from '../panels/race_strip'
import {
  notifyError,
  scenario,
  setLanguage,
  setTheme,
  showView,
  type ThemeChoice,
  theme,
  themeChoice,
  view,
} from '../state'
import { show } from '../state/dialogs'
import { received } from '../state/received'
import { Button, IconButton } from '../ui/buttons'
import { Icon } from '../ui/icon'
import { lazily } from '../ui/lazily'
import { Menu, MenuItem } from '../ui/menu'
import { Logo } from './logo'
import { MapMenu } from './map_menu'

const ReceivedStrip = lazily(async () => (await import('../dialogs/all_dialogs')).fetchStrip())

export function Header() {
  const started = scenario.value !== null
  const ready = started && view.value === 'race'
  return (
    <header class="header">
      <h1 class="brand">
        <Logo />
        <span>Formicarium</span>
      </h1>
      {started && <ViewSwitch />}
      {ready && <MapMenu />}
      {ready ? <RaceStrip /> : <span class="spacer" />}
      {received.value && <ReceivedStrip />}
      {ready && (
        <Button
          label={t('header.share')}
          icon={Share2}
          tone="primary"
          testId="share"
          onClick={() => show('share')}
        />
      )}
      <ThemeMenu />
      <LanguageMenu />
      <IconButton
        icon={CircleQuestionMark}
        label={t('header.help')}
        keys="?"
        testId="help"
        onClick={() => show('help')}
      />
    </header>
  )
}

const VIEWS = { race: Eye, lab: ChartColumn } as const

/** Names where there is room for them, pictures on a phone. */
function ViewSwitch() {
  return (
    <fieldset class="segmented view-choice">
      <legend class="visually-hidden">{t('header.view')}</legend>
      {(['race', 'lab'] as const).map((each) => (
        <button
          key={each}
          type="button"
          class="segment"
          aria-pressed={view.value === each}
          data-testid={`view-${each}`}
          onClick={() => showView(each)}
        >
          <Icon icon={VIEWS[each]} size={16} />
          <span>{t(`header.views.${each}`)}</span>
        </button>
      ))}
    </fieldset>
  )
}

const THEME_ICONS = { system: Monitor, light: Sun, dark: Moon } as const

function ThemeMenu() {
  return (
    <Menu
      label={t('header.theme')}
      face={<Icon icon={THEME_ICONS[theme.value]} />}
      testId="theme"
      align="end"
      bare
    >
      {(Object.keys(THEME_ICONS) as ThemeChoice[]).map((choice) => (
        <MenuItem
          key={choice}
          icon={THEME_ICONS[choice]}
          label={t(`header.themes.${choice}`)}
          testId={`theme-${choice}`}
          checked={themeChoice.value === choice}
          onClick={() => setTheme(choice)}
        />
      ))}
    </Menu>
  )
}

function LanguageMenu() {
  return (
    <Menu
      label={t('header.language')}
      face={<Icon icon={Languages} />}
      testId="language"
      align="end"
      bare
    >
      {(Object.keys(LANGUAGES) as Language[]).map((choice) => (
        <MenuItem
          key={choice}
          label={LANGUAGES[choice]}
          testId={`language-${choice}`}
          checked={language.value === choice}
          onClick={() => setLanguage(choice).catch(notifyError)}
        />
      ))}
    </Menu>
  )
}
