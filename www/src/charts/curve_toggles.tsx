/** Which curves are drawn beside the best so far. */
import type { Signal } from '@preact/signals'
import { t } from '../i18n/column'
import { showIterationBest, showMean } from './shown_curves'

export function CurveToggles() {
  return (
    <ul class="legend">
      <Toggle label={t('chart.iterationBest')} kind="iteration-best" of={showIterationBest} />
      <Toggle label={t('chart.mean')} kind="mean" of={showMean} />
    </ul>
  )
}

function Toggle(props: { label: string; kind: string; of: Signal<boolean> }) {
  return (
    <li>
      <label class="toggle">
        <input
          type="checkbox"
          checked={props.of.value}
          onChange={(event) => {
            props.of.value = event.currentTarget.checked
          }}
        />
        <span class={`line-sample ${props.kind}`} aria-hidden="true" />
        {props.label}
      </label>
    </li>
  )
}
