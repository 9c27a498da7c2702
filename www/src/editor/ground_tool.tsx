/** The tool that makes ground dearer: its button, and what it draws with, in a card beside the button. */
import { Brush, type IconNode, PaintBucket, Weight } from 'lucide'
import { useRef } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/editor'
import { MOST_FACTOR, PLAIN } from '../model/weights'
import { tool } from '../state'
import { Labelled, NumberField, Segmented } from '../ui/fields'
import { Icon } from '../ui/icon'
import { BLOCK, LINE, RECTANGLE } from './draw_icons'
import { type DrawnShape, FACTORS, factor, GROUND_SHAPES, groundShape } from './hand'
import { placeBeside } from './tool_list'

const ID = 'ground-card'
const ICONS: Record<DrawnShape, IconNode> = {
  brush: Brush,
  line: LINE,
  rectangle: RECTANGLE,
  block: BLOCK,
  fill: PaintBucket,
}

/** As it is written everywhere: × 3. */
const times = (value: number) => t('editor.times', { factor: numbers.value.metres.format(value) })

export function GroundTool() {
  const card = useRef<HTMLDivElement>(null)
  const chosen = tool.value === 'ground'
  const name = t('editor.groundNow', { factor: times(factor.value) })
  const label = chosen ? t('editor.more', { tool: name }) : name
  return (
    <>
      <button
        type="button"
        class="icon-button plain"
        aria-label={label}
        aria-pressed={chosen}
        aria-haspopup="dialog"
        aria-expanded="false"
        popoverTarget={ID}
        data-tip={`${label} · U`}
        data-testid="tool-ground"
        onClick={(event) => {
          if (!chosen) event.preventDefault()
          tool.value = 'ground'
        }}
      >
        <Icon icon={Weight} />
      </button>
      <div
        ref={card}
        id={ID}
        popover="auto"
        role="dialog"
        aria-label={t('editor.tools.ground')}
        class="menu tool-list ground-card"
        onToggle={(event) => {
          if (placeBeside(event, card.current))
            card.current?.querySelector<HTMLElement>('[aria-pressed="true"], input')?.focus()
        }}
        onKeyDown={(event) => {
          // The card closes; the tool stays in hand.
          if (event.key === 'Escape') event.stopPropagation()
        }}
      >
        <GroundFields />
      </div>
    </>
  )
}

function GroundFields() {
  const set = (value: number) => {
    if (isFactor(value)) factor.value = value
  }
  return (
    <>
      <Labelled label={t('editor.costs')}>
        <Segmented
          label={t('editor.costs')}
          value={String(factor.value)}
          options={FACTORS.map((value) => ({
            value: String(value),
            label: times(value),
            testId: `factor-${value}`,
          }))}
          onChange={(value) => set(Number(value))}
        />
      </Labelled>
      <Labelled label={t('editor.otherFactor', { most: MOST_FACTOR })}>
        <NumberField
          label={t('editor.otherFactor', { most: MOST_FACTOR })}
          hideLabel
          value={factor.value}
          min={PLAIN}
          max={MOST_FACTOR}
          testId="factor-other"
          onChange={set}
          onType={set}
        />
      </Labelled>
      <Labelled label={t('editor.drawnBy')}>
        <Segmented
          label={t('editor.drawnBy')}
          value={groundShape.value}
          options={GROUND_SHAPES.map((shape) => ({
            value: shape,
            label: t(`editor.tools.${shape === 'brush' ? 'wall' : shape}`),
            testId: `ground-${shape}`,
            icon: <Icon icon={ICONS[shape]} />,
          }))}
          onChange={(shape) => {
            groundShape.value = shape
          }}
        />
      </Labelled>
      <p class="hint">{t('editor.groundHint')}</p>
    </>
  )
}

const isFactor = (value: number) => value >= PLAIN && value <= MOST_FACTOR
