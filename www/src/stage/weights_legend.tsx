/** What the tints of weighted ground mean, and what hatched cells are. */
import { numbers } from '../i18n'
import { t } from '../i18n/weights'
import type { LayerEnds } from '../model/messages'
import { theme } from '../state'
import { hasNarrow, isDear, isDearer } from './felt_ground'
import { weightColoursOf } from './layer_colours'
import { Ramp, Row } from './legend_rows'

export function OfWeights({ range }: { range: LayerEnds }) {
  const colours = weightColoursOf(theme.value)
  if (!isDear.value) return <Row title={t('weights.robot')} note={t('weights.hatched')} />
  if (!colours) return null
  const write = (value: number) =>
    t(value === range[1] && isDearer.value ? 'weights.orMore' : 'weights.times', {
      factor: numbers.value.metres.format(value),
    })
  const note = hasNarrow.value ? t('weights.hatched') : undefined
  return (
    <Ramp title={t('weights.legend')} note={note} ends={range} colours={colours} write={write} />
  )
}
