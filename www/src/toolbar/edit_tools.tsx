import { BrickWall, CircleDot, Compass, Eraser, Flag, Hand, MapPinPlus, Redo2, Undo2 } from 'lucide'
import { t } from '../i18n'
import { goalName } from '../model/goals'
import { activeGoal, canRedo, canUndo, redo, scenario, type Tool, tool, undo } from '../state'
import { IconButton } from '../ui/buttons'

const TOOLS = [
  { id: 'wall', icon: BrickWall, keys: 'W' },
  { id: 'erase', icon: Eraser, keys: 'E' },
  { id: 'start', icon: CircleDot, keys: 'S' },
  { id: 'goal', icon: Flag, keys: 'G' },
  { id: 'add-goal', icon: MapPinPlus, keys: 'A' },
  { id: 'inspect', icon: Compass, keys: 'I' },
  { id: 'pan', icon: Hand, keys: 'H' },
] as const satisfies { id: Tool; icon: unknown; keys: string }[]

/** With several goals the tool moves the one last taken up. */
function goalToolName(): string {
  const spec = scenario.value?.spec
  if (!spec || spec.goals.length < 2) return t('tools.goal')
  return t('tools.goalNamed', { name: goalName(spec, activeGoal.value) })
}

export function EditTools() {
  return (
    <div class="toolbar-group edit-tools" role="toolbar" aria-label={t('tools.group')}>
      <div class="tool-set">
        {TOOLS.map(({ id, icon, keys }) => (
          <IconButton
            key={id}
            icon={icon}
            label={id === 'goal' ? goalToolName() : t(`tools.${id}`)}
            keys={keys}
            pressed={tool.value === id}
            testId={`tool-${id}`}
            onClick={() => {
              tool.value = id
            }}
          />
        ))}
      </div>
      <span class="divider" />
      <IconButton
        icon={Undo2}
        label={t('tools.undo')}
        keys="Ctrl+Z"
        testId="undo"
        disabled={!canUndo.value}
        onClick={undo}
      />
      <IconButton
        icon={Redo2}
        label={t('tools.redo')}
        keys="Ctrl+Shift+Z"
        testId="redo"
        disabled={!canRedo.value}
        onClick={redo}
      />
    </div>
  )
}
