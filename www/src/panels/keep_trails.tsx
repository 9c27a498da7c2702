/** The reader's choice when walls change while planners run, and what has changed so far. */
import { t } from '../i18n/walls'
import { reset } from '../state'
import { keepTrails, madeChanges, setKeepTrails } from '../state/changing_walls'
import { lazyParts } from '../state/lazy_parts'
import { Button } from '../ui/buttons'
import { Select } from '../ui/fields'

/** With its words and all that it takes. */
export async function fetchKeepTrails(): Promise<typeof KeepTrails> {
  await lazyParts.walls()
  return KeepTrails
}

function KeepTrails() {
  const made = madeChanges.value.length
  return (
    <fieldset class="keep-trails" aria-label={t('walls.label')}>
      <Select
        label={t('walls.label')}
        value={keepTrails.value ? 'keep' : 'anew'}
        testId="keep-trails"
        note={t(keepTrails.value ? 'walls.keepNote' : 'walls.anewNote')}
        options={[
          { value: 'anew', label: t('walls.anew'), note: t('walls.anewNote') },
          { value: 'keep', label: t('walls.keep'), note: t('walls.keepNote') },
        ]}
        onChange={(value) => setKeepTrails(value === 'keep')}
      />
      {made > 0 && (
        <p role="status">
          {t('walls.made', { count: made })}
          <Button label={t('walls.begin')} testId="begin-on-this-map" onClick={reset} />
        </p>
      )}
    </fieldset>
  )
}
