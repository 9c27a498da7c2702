import { Plus } from 'lucide'
import { t } from '../i18n'
import { MAX_PANELS } from '../session'
import { addPanel, catalog, panels } from '../state'
import { Button } from '../ui/buttons'
import { Icon } from '../ui/icon'
import { Menu, MenuHeading, MenuItem } from '../ui/menu'
import { FAMILIES, plannerName, plannerSummary } from './planner_text'

export function AddPlannerMenu() {
  if (panels.value.length >= MAX_PANELS) return null
  return (
    <Menu
      label={t('panels.add')}
      testId="add-panel"
      align="end"
      face={
        <span class="menu-face">
          <Icon icon={Plus} size={16} />
          <span>{t('panels.add')}</span>
        </span>
      }
    >
      {FAMILIES.map((family) => (
        <FamilyItems key={family} family={family} />
      ))}
    </Menu>
  )
}

function FamilyItems({ family }: { family: (typeof FAMILIES)[number] }) {
  const entries = catalog.value?.planners.filter((entry) => entry.family === family) ?? []
  if (entries.length === 0) return null
  return (
    <>
      <MenuHeading text={t(`family.${family}`)} />
      {entries.map((entry) => (
        <MenuItem
          key={entry.id}
          label={plannerName(entry)}
          note={plannerSummary(entry)}
          testId={`add-${entry.id}`}
          onClick={() => addPanel(entry.id)}
        />
      ))}
    </>
  )
}

export function AddPlannerButtons() {
  return (
    <div class="button-row">
      {catalog.value?.planners.map((entry) => (
        <Button
          key={entry.id}
          icon={Plus}
          label={plannerName(entry)}
          onClick={() => addPanel(entry.id)}
        />
      ))}
    </div>
  )
}
