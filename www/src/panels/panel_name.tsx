/** What a panel is called, as text that turns into a field. The field lies over the text, so nothing moves. */
import { useSignal } from '@preact/signals'
import { useRef } from 'preact/hooks'
import { t } from '../i18n/names'
import { panelTitle } from '../words/planner_words'
import { LabelField } from './label_field'

/** Double click, Enter or F2 renames; on a touch screen one tap does. */
export function PanelName({ panelId, place }: { panelId: number; place: number }) {
  const editing = useSignal(false)
  const button = useRef<HTMLButtonElement>(null)
  const edit = () => {
    editing.value = true
  }
  const title = panelTitle(panelId)
  return (
    <>
      <button
        ref={button}
        type="button"
        title={`${title} · ${t('names.rename')}: F2`}
        data-testid={`label-${place}`}
        onClick={({ detail }) => {
          // A single click of a mouse is 1, a key 0.
          if (detail !== 1 || matchMedia('(pointer: coarse)').matches) edit()
        }}
        onKeyDown={({ key }) => {
          if (key === 'F2') edit()
        }}
      >
        <Parts title={title} />
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
    </>
  )
}

/** Where there is no room for all of it, what tells it from others goes before the end of the name that they share. */
function Parts({ title }: { title: string }) {
  const at = title.indexOf(' · ')
  if (at < 0) return <bdi>{title}</bdi>
  return (
    <>
      <bdi>{title.slice(0, at)}</bdi>
      <bdi class="mark">{title.slice(at)}</bdi>
    </>
  )
}
