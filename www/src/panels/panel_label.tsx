/** What a panel is called, as text that turns into a field. The field lies over the text, so nothing moves. */
import { useSignal } from '@preact/signals'
import { useRef } from 'preact/hooks'
import { t } from '../i18n'
import { lazily } from '../ui/lazily'
import { panelTitle } from '../words/planner_words'

interface PanelLabelProps {
  panelId: number
  /** 1 for the first on the page. */
  place: number
}

const LabelField = lazily(async () => (await import('./label_field')).fetchLabelField())

/** Double click, Enter or F2 renames; on a touch screen one tap does. */
export function PanelLabel({ panelId, place }: PanelLabelProps) {
  const editing = useSignal(false)
  const button = useRef<HTMLButtonElement>(null)
  const edit = () => {
    editing.value = true
  }
  const title = panelTitle(panelId)
  return (
    <span class="panel-label">
      <button
        ref={button}
        type="button"
        title={`${title} · ${t('panels.rename')}: F2`}
        data-testid={`label-${place}`}
        onClick={({ detail }) => {
          // A single click of a mouse is 1, a key 0.
          if (detail !== 1 || matchMedia('(pointer: coarse)').matches) edit()
        }}
        onKeyDown={({ key }) => {
          if (key === 'F2') edit()
        }}
      >
        <bdi>{title}</bdi>
      </button>
      {editing.value && (
        <LabelField
          panelId={panelId}
          place={place}
          onDone={(byKey) => {
            editing.value = false
            if (byKey) button.current?.focus()
          }}
        />
      )}
    </span>
  )
}
