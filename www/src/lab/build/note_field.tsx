import { useId } from 'preact/hooks'
import { t } from '../../i18n/lab'
import { LONGEST } from '../../model/names'
import { note } from './draft'

/** What the reader says of the comparison: it stands in its document as what is asked. */
export function NoteField() {
  const id = useId()
  return (
    <div class="builder-row">
      <label class="field-label" for={id}>
        {t('lab.build.note')}
      </label>
      <textarea
        id={id}
        class="input note-area"
        dir="auto"
        rows={2}
        maxLength={LONGEST.note}
        value={note.value}
        placeholder={t('lab.build.asks')}
        data-testid="study-note"
        onInput={(event) => {
          note.value = event.currentTarget.value
        }}
      />
    </div>
  )
}
