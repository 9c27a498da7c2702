import { ArrowUpRight } from 'lucide'
import { t } from '../../i18n/embed'
import type { Control } from '../../model/embedding'
import { narrow } from '../../state'
import { ScrubberPlace } from '../../toolbar/play_bar'
import { SpeedField } from '../../toolbar/speed_field'
import { Transport } from '../../toolbar/transport'
import { Icon } from '../../ui/icon'
import { askFullPage, fullPage } from './full_page'

/** Below the maps: what runs them, as far as the address asks for it, and always the way to the full page. */
export function Bar({ controls }: { controls: ReadonlySet<Control> }) {
  const plays = controls.has('play')
  const steps = controls.has('step')
  return (
    <section class="play-bar" aria-label={t('embed.bar')} data-bare={!plays && !steps}>
      {(plays || steps) && <Transport plays={plays} steps={steps} stops={false} />}
      {plays && !narrow.value && <SpeedField />}
      {plays ? <ScrubberPlace /> : <span class="spacer" />}
      <FullPageLink />
    </section>
  )
}

/** Its address holds the race of now: it is made as soon as somebody is about to press it. */
function FullPageLink() {
  return (
    <a
      class="full-page"
      href={fullPage.value}
      target="_blank"
      rel="noopener"
      aria-label={t('embed.mark')}
      title={t('embed.mark')}
      data-testid="full-page"
      onPointerEnter={askFullPage}
      onPointerDown={askFullPage}
      onFocus={askFullPage}
    >
      <span>Formicarium</span>
      <Icon icon={ArrowUpRight} size={14} />
    </a>
  )
}
