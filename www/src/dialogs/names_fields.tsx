/** Title and note of the session and the name of its map. What is typed holds at once; a visit to a field is one step to undo. */
import { useId, useRef, useState } from 'preact/hooks'
import { numbers } from '../i18n'
import { t } from '../i18n/names'
import { LONGEST } from '../model/names'
import { caption } from '../state'
import { renameMap, setCaption } from '../state/naming'
import { mapName } from '../words/map_names'

export function NamesFields() {
  return (
    <div class="names-fields">
      <TitleField />
      <NoteField />
      <MapNameField />
    </div>
  )
}

function TitleField() {
  const id = useId()
  const visit = useVisit()
  return (
    <div class="name-field">
      <label for={id}>{t('names.title')}</label>
      <input
        {...visit.field}
        id={id}
        class="input"
        dir="auto"
        maxLength={LONGEST.title}
        defaultValue={caption.peek().title}
        placeholder={t('names.titleEmpty')}
        data-testid="session-title"
        onInput={({ currentTarget }) =>
          setCaption({ title: currentTarget.value }, visit.gesture.current)
        }
      />
    </div>
  )
}

function NoteField() {
  const id = useId()
  const visit = useVisit()
  const [typed, setTyped] = useState(caption.peek().note.length)
  const { whole } = numbers.value
  return (
    <div class="name-field">
      <label for={id}>{t('names.note')}</label>
      <textarea
        {...visit.field}
        id={id}
        class="input note-area"
        dir="auto"
        rows={3}
        maxLength={LONGEST.note}
        defaultValue={caption.peek().note}
        placeholder={t('names.noteEmpty')}
        aria-describedby={`${id}-left`}
        data-testid="session-note"
        onInput={({ currentTarget }) => {
          setTyped(currentTarget.value.length)
          setCaption({ note: currentTarget.value }, visit.gesture.current)
        }}
      />
      <p class="hint" id={`${id}-left`}>
        {t('names.noteLeft', { count: typed, most: whole.format(LONGEST.note) })}
      </p>
    </div>
  )
}

/** Emptied, the field says so, and the map keeps the name it had. */
function MapNameField() {
  const id = useId()
  const visit = useVisit()
  const [former] = useState(mapName)
  const [empty, setEmpty] = useState(false)
  return (
    <div class="name-field">
      <label for={id}>{t('names.map')}</label>
      <input
        {...visit.field}
        id={id}
        class="input"
        dir="auto"
        maxLength={LONGEST.map}
        defaultValue={former}
        aria-invalid={empty}
        aria-describedby={`${id}-empty`}
        data-testid="map-name-field"
        onInput={({ currentTarget }) =>
          setEmpty(!renameMap(currentTarget.value, visit.gesture.current))
        }
      />
      <p class="hint" id={`${id}-empty`} role="status">
        {empty ? t('names.mapEmpty') : ''}
      </p>
    </div>
  )
}

/** Gestures on the map count upwards; −1 and −2 are those of levels. */
let lastVisit = -2
const newVisit = () => --lastVisit

/** What is typed in one visit to a field is undone together. */
function useVisit() {
  const gesture = useRef(newVisit())
  const onFocus = () => {
    gesture.current = newVisit()
  }
  return { gesture, field: { onFocus } }
}
