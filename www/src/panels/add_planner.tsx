import type { CatalogEntry } from '@pkg/formicarium'
import { BookOpen, Plus, RotateCw } from 'lucide'
import { t } from '../i18n'
import { MAX_PANELS } from '../model/session'
import {
  addPanel,
  catalog,
  fetchWholeEngine,
  fetchWholeEngineUnasked,
  panels,
  wholeEngine,
} from '../state'
import { Button } from '../ui/buttons'
import { Icon } from '../ui/icon'
import { Menu, MenuHeading, MenuIcon, MenuItem } from '../ui/menu'
import { cardOf, showCard } from '../words/paper_cards'
import { FAMILIES, plannerName, plannerSummary, whyNot } from '../words/planner_words'

/** More buttons than this would be too many. */
const MOST_BUTTONS = 8

export function AddPlannerMenu() {
  const full = panels.value.length >= MAX_PANELS
  return (
    <Menu
      label={t('panels.add')}
      testId="add-panel"
      align="end"
      onOpen={fetchWholeEngineUnasked}
      face={
        <span class="menu-face">
          <Icon icon={Plus} size={16} />
          <span>{t('panels.add')}</span>
        </span>
      }
    >
      {full && <MenuHeading text={t('panels.full', { count: MAX_PANELS })} />}
      {FAMILIES.map((family) => (
        <FamilyItems key={family} family={family} full={full} />
      ))}
      <RestItem />
    </Menu>
  )
}

function FamilyItems({ family, full }: { family: (typeof FAMILIES)[number]; full: boolean }) {
  const entries = catalog.value?.planners.filter((entry) => entry.family === family) ?? []
  if (entries.length === 0) return null
  return (
    <>
      <MenuHeading text={t(`family.${family}`)} />
      {entries.map((entry) => (
        <PlannerItem key={entry.id} entry={entry} full={full} />
      ))}
    </>
  )
}

/** The summary of a planner can be read even where it cannot be used. */
function PlannerItem({ entry, full }: { entry: CatalogEntry; full: boolean }) {
  const card = cardOf(entry.id)
  const name = plannerName(entry)
  return (
    <div class="menu-row" role="presentation">
      <MenuItem
        label={name}
        note={plannerSummary(entry)}
        unavailable={whyNot(entry) ?? (full ? plannerSummary(entry) : null)}
        testId={`add-${entry.id}`}
        onClick={() => addPanel(entry.id)}
      />
      {card && (
        <MenuIcon
          icon={BookOpen}
          label={t('papers.about', { name })}
          testId={`about-${entry.id}`}
          onClick={() => showCard(card)}
        />
      )}
    </div>
  )
}

/** Says whether the list is complete, and offers to fetch what is missing. */
function RestItem() {
  if (wholeEngine.value === 'here') return null
  if (wholeEngine.value !== 'failed') return <MenuHeading text={t('panels.fetchingMore')} />
  return (
    <MenuItem
      icon={RotateCw}
      label={t('panels.fetchMore')}
      note={t('panels.moreNotFetched')}
      testId="fetch-planners"
      onClick={fetchWholeEngine}
    />
  )
}

/** The planners of a first visit, one press away; the menu has the others. */
export function AddPlannerButtons() {
  const usable = (catalog.value?.planners ?? []).filter((entry) => whyNot(entry) === null)
  return (
    <div class="button-row">
      {usable.slice(0, MOST_BUTTONS).map((entry) => (
        <Button
          key={entry.id}
          icon={Plus}
          label={plannerName(entry)}
          onClick={() => addPanel(entry.id)}
        />
      ))}
      {wholeEngine.value === 'failed' && (
        <Button
          icon={RotateCw}
          label={t('panels.fetchMore')}
          tone="quiet"
          onClick={fetchWholeEngine}
        />
      )}
    </div>
  )
}
