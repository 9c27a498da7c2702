/** What a run depends on; every change begins it anew. */
import type { ParamKind, ParamSpec } from '@pkg/formicarium'
import { type DialogKey, t } from '../i18n/dialogs'
import type { OrderPlay } from '../state/order_play'
import { NumberField, Segmented, Select } from '../ui/fields'

const PSEUDO_RANDOM = 'pseudo-random-proportional'

export function OrderSettingFields({ play }: { play: OrderPlay }) {
  const { open, seed, params } = play.settings.value
  const numbers = play.facts.value.params.flatMap((spec) => {
    const range = rangeOf(spec.kind)
    return range ? [{ spec, ...range }] : []
  })
  // Without its rule, q0 has no effect.
  const hasEffect = ({ key }: ParamSpec) => key !== 'q0' || params.rule === PSEUDO_RANDOM
  return (
    <div class="field-row order-settings">
      <Segmented
        label={t('order.shape')}
        value={open ? 'open' : 'closed'}
        options={(['closed', 'open'] as const).map((value) => ({
          value,
          label: t(`order.${value}`),
          testId: `order-${value}`,
        }))}
        onChange={(value) => play.set({ open: value === 'open' })}
      />
      <Select
        label={t('order.rule')}
        value={String(params.rule)}
        testId="order-rule"
        options={(['random-proportional', PSEUDO_RANDOM] as const).map((value) => ({
          value,
          label: t(`order.rules.${value}`),
        }))}
        onChange={(value) => play.setParam('rule', value)}
      />
      <NumberField
        label={t('order.seed')}
        value={seed}
        min={0}
        max={2 ** 32 - 1}
        step={1}
        nearest
        testId="order-seed"
        onChange={(value) => play.set({ seed: value })}
      />
      {numbers
        .filter(({ spec }) => hasEffect(spec))
        .map(({ spec: { key }, min, max, step }) => (
          <NumberField
            key={key}
            label={t(`order.params.${key}` as DialogKey)}
            value={Number(params[key])}
            min={min}
            max={max}
            step={step}
            testId={`order-${key}`}
            onChange={(value) => play.setParam(key, value)}
          />
        ))}
    </div>
  )
}

function rangeOf(kind: ParamKind) {
  if (kind.type === 'integer') return { min: kind.min, max: kind.max, step: 1 }
  if (kind.type === 'real') return { min: kind.min, max: kind.max, step: 'any' as const }
  return null
}
