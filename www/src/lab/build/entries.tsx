/** The entries of the draft: planners with their parameters, and imported results. */
import type { CatalogEntry } from '@pkg/formicarium'
import { Plus, RotateCw } from 'lucide'
import { t } from '../../i18n/lab'
import { catalog, fetchWholeEngine, wholeEngine } from '../../state'
import { Icon } from '../../ui/icon'
import { Menu, MenuHeading, MenuItem } from '../../ui/menu'
import { FAMILIES, plannerName, plannerSummary } from '../../words/planner_words'
import { instanceIds } from './compose_document'
import { addEntry, entries, maps } from './draft'
import { EntryRow } from './entry_row'
import { ImportedFiles, ImportedResults } from './imported_results'
import { whyNotHere } from './why_not'

export function Entries() {
  return (
    <fieldset class="builder-part">
      <legend>{t('lab.build.planners')}</legend>
      <ul class="draft-entries">
        {entries.value.map((entry, place) => (
          <EntryRow key={entry.key} entry={entry} place={place} />
        ))}
      </ul>
      {entries.value.length === 0 && <p class="hint">{t('lab.build.noPlanners')}</p>}
      <ImportedFiles />
      <div class="add-entries">
        <AddEntry />
        <ImportedResults maps={places()} />
      </div>
    </fieldset>
  )
}

function places() {
  const ids = instanceIds()
  return maps.value.map(({ name }, at) => ({ id: ids[at] ?? '', name }))
}

function AddEntry() {
  return (
    <Menu
      label={t('lab.build.addPlanner')}
      testId="lab-add-planner"
      face={
        <span class="menu-face">
          <Icon icon={Plus} size={16} />
          <span>{t('lab.build.addPlanner')}</span>
        </span>
      }
    >
      {FAMILIES.map((family) => (
        <Family key={family} of={planners(family)} heading={t(`family.${family}`)} />
      ))}
      {wholeEngine.value === 'fetching' && <MenuHeading text={t('panels.fetchingMore')} />}
      {wholeEngine.value === 'failed' && (
        <MenuItem
          icon={RotateCw}
          label={t('panels.fetchMore')}
          note={t('panels.moreNotFetched')}
          onClick={fetchWholeEngine}
        />
      )}
    </Menu>
  )
}

const planners = (family: (typeof FAMILIES)[number]) =>
  catalog.value?.planners.filter((entry) => entry.family === family) ?? []

function Family({ of, heading }: { of: CatalogEntry[]; heading: string }) {
  if (of.length === 0) return null
  return (
    <>
      <MenuHeading text={heading} />
      {of.map((entry) => (
        <MenuItem
          key={entry.id}
          label={plannerName(entry)}
          note={plannerSummary(entry)}
          unavailable={whyNotHere(entry)}
          testId={`lab-add-${entry.id}`}
          onClick={() => addEntry(entry.id)}
        />
      ))}
    </>
  )
}
