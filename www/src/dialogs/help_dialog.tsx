import { t } from '../i18n/dialogs'
import { oneFile, partAddress } from '../model/one_file'
import { engineVersion } from '../state'
import { closeDialog } from '../state/dialogs'
import { Dialog } from '../ui/dialog'
import { lazily } from '../ui/lazily'

const OfflineSection = lazily(async () => (await import('../offline')).fetchSection())

type KeyName =
  | 'play'
  | 'move'
  | 'iteration'
  | 'look'
  | 'reset'
  | 'end'
  | 'undo'
  | 'redo'
  | 'tools'
  | 'shapes'
  | 'ground'
  | 'select'
  | 'width'
  | 'fit'
  | 'relief'
  | 'focus'
  | 'column'
  | 'rename'
type StageKeyName =
  | 'cursor'
  | 'apply'
  | 'remove'
  | 'corners'
  | 'part'
  | 'clipboard'
  | 'level'
  | 'turn'
  | 'pointer'
  | 'zoom'
  | 'pan'
  | 'help'
  | 'leave'

const RUN_KEYS: [KeyName, string[]][] = [
  ['play', ['Space']],
  ['move', ['→']],
  ['iteration', ['Shift →', ']']],
  ['look', [',', '.']],
  ['reset', ['R', 'Home']],
  ['end', ['End']],
  ['undo', ['Ctrl Z']],
  ['redo', ['Ctrl Shift Z', 'Ctrl Y']],
  ['tools', ['W', 'E', 'S', 'G', 'A', 'I', 'H']],
  ['shapes', ['L', 'B', 'N', 'D']],
  ['ground', ['U']],
  ['width', ['J', 'K']],
  ['select', ['M']],
  ['fit', ['0']],
  ['relief', ['3']],
  ['focus', ['F']],
  ['column', ['C']],
  ['rename', ['F2']],
]

const MAP_KEYS: [StageKeyName, string[]][] = [
  ['cursor', ['←', '↑', '↓', '→']],
  ['apply', ['Enter', 'X']],
  ['remove', ['Delete']],
  ['corners', ['Enter', 'Enter']],
  ['part', ['←', 'Delete', 'Esc']],
  ['clipboard', ['Ctrl C', 'Ctrl X', 'Ctrl V', 'Ctrl A']],
  ['level', ['PgUp', 'PgDn']],
  ['turn', ['←', 'Shift ←']],
  ['pointer', []],
  ['zoom', []],
  ['pan', []],
  ['help', ['?']],
  ['leave', ['Esc']],
]

const LICENCES = 'licences.txt'

/** Beside the page; or inside it, where browsers save such a file rather than show it. */
const licences = () =>
  oneFile()
    ? { href: partAddress(LICENCES, 'text/plain'), download: LICENCES }
    : { href: `./${LICENCES}`, target: '_blank', rel: 'noopener' }

export function HelpDialog() {
  return (
    <Dialog title={t('help.title')} onClose={closeDialog} testId="help-dialog" wide prose>
      <p>{t('help.about')}</p>
      <ol class="help-steps">
        <li>{t('help.step1')}</li>
        <li>{t('help.step2')}</li>
        <li>{t('help.step3')}</li>
      </ol>
      <div class="key-columns">
        <KeyTable title={t('help.runKeys')} rows={RUN_KEYS} />
        <KeyTable title={t('help.mapKeys')} rows={MAP_KEYS} />
      </div>
      <OfflineSection />
      <p class="hint">{t('help.scripting', { version: engineVersion.value })}</p>
      <p class="hint">
        <a class="link" {...licences()}>
          {t('help.licences')}
        </a>
      </p>
    </Dialog>
  )
}

function KeyTable({ title, rows }: { title: string; rows: [KeyName | StageKeyName, string[]][] }) {
  return (
    <section>
      <h3>{title}</h3>
      <dl class="keys">
        {rows.map(([name, keys]) => (
          <div key={name}>
            <dt>{t(`help.keys.${name}`)}</dt>
            <dd>
              {keys.map((key) => (
                <kbd key={key}>{key}</kbd>
              ))}
            </dd>
          </div>
        ))}
      </dl>
    </section>
  )
}
