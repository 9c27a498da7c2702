/** The part of a share dialog that gives the HTML of a frame with the same race or comparison in it. */
import '../styles/embed_snippet.css'
import { signal } from '@preact/signals'
import { Copy } from 'lucide'
import { t } from '../i18n/embed'
import {
  CONTROLS,
  type Control,
  embeddedAddress,
  frameSnippet,
  USUAL_CONTROLS,
} from '../model/embedding'
import { LINK_LIMIT } from '../share/envelope'
import { Button } from '../ui/buttons'
import { copyText } from '../ui/copy_text'
import { NumberField } from '../ui/fields'

interface EmbedSnippetProps {
  /** The link that is shared. */
  link: string
  /** What the frame is called. */
  name: string
  /** Whether there are controls to choose; a comparison has its own. */
  isRace: boolean
}

/** Kept as long as the page is open: several frames of a course look alike. */
const height = signal(480)
const chosen = signal<readonly Control[]>(USUAL_CONTROLS)

const MIN_HEIGHT = 240
const MAX_HEIGHT = 2000

export function EmbedSnippet({ link, name, isRace }: EmbedSnippetProps) {
  const [page = '', fragment = ''] = link.split(/(?=#)/)
  // From a page that came from no host there is no address to frame.
  if (page === '' || page.startsWith('#')) return null
  const address = embeddedAddress(page, isRace ? { controls: chosen.value } : {}, fragment)
  const html = frameSnippet(address, name, height.value)
  return (
    <details class="embed-snippet">
      <summary data-testid="embed-open">{t('embed.share.title')}</summary>
      <p class="hint">{t('embed.share.about')}</p>
      {isRace && <Controls />}
      <NumberField
        label={t('embed.share.height')}
        value={height.value}
        min={MIN_HEIGHT}
        max={MAX_HEIGHT}
        step={10}
        nearest
        testId="embed-height"
        onChange={(value) => {
          height.value = value
        }}
      />
      <textarea
        class="input preview"
        rows={4}
        readOnly
        value={html}
        aria-label={t('embed.share.code')}
        data-testid="embed-html"
        onFocus={(event) => event.currentTarget.select()}
      />
      {isLocal && <p class="hint">{t('embed.share.local')}</p>}
      {address.length > LINK_LIMIT && <p class="hint">{t('embed.share.long')}</p>}
      <Button
        icon={Copy}
        label={t('embed.share.copy')}
        testId="embed-copy"
        onClick={() => copyText(html)}
      />
    </details>
  )
}

const isLocal =
  /^(localhost|127\.|\[::1\])/.test(location.hostname) || location.protocol === 'file:'

function Controls() {
  return (
    <fieldset class="embed-controls">
      <legend>{t('embed.share.controls')}</legend>
      {CONTROLS.map((control) => (
        <label key={control}>
          <input
            type="checkbox"
            checked={chosen.value.includes(control)}
            data-testid={`embed-control-${control}`}
            onChange={(event) => choose(control, event.currentTarget.checked)}
          />{' '}
          {t(`embed.controls.${control}`)}
        </label>
      ))}
    </fieldset>
  )
}

/** In the order of the list, so that equal choices give equal lines. */
function choose(control: Control, wanted: boolean): void {
  const now = new Set(chosen.peek())
  if (wanted) now.add(control)
  else now.delete(control)
  chosen.value = CONTROLS.filter((one) => now.has(one))
}
