import { BrickWall, CircleDot, Compass, Eraser, Flag, Hand, MapPinPlus } from 'lucide'
import { useEffect } from 'preact/hooks'
import { t } from '../i18n'
import { goalName } from '../model/goals'
import {
  activeGoal,
  canRedo,
  canUndo,
  editor,
  handUndoing,
  redo,
  scenario,
  type Tool,
  tool,
  type Undoing,
  undo,
  wholeEngine,
  withEditor,
} from '../state'
import { IconButton } from '../ui/buttons'
import { UndoButtons } from '../ui/undo_buttons'

const TOOLS = [
  { id: 'erase', icon: Eraser, keys: 'E' },
  { id: 'start', icon: CircleDot, keys: 'S' },
  { id: 'goal', icon: Flag, keys: 'G' },
  { id: 'add-goal', icon: MapPinPlus, keys: 'A' },
  { id: 'inspect', icon: Compass, keys: 'I' },
  { id: 'pan', icon: Hand, keys: 'H' },
] as const satisfies { id: Tool; icon: unknown; keys: string }[]

const OF_MAP: Undoing = {
  canUndo,
  canRedo,
  undo,
  redo,
  words: () => ({ undo: t('tools.undo'), redo: t('tools.redo') }),
}

/** With several goals the tool moves the one last taken up. */
function goalToolName(): string {
  const spec = scenario.value?.spec
  if (!spec || spec.goals.length < 2) return t('tools.goal')
  return t('tools.goalNamed', { name: goalName(spec, activeGoal.value) })
}

/** Shows the one used last of the tools that draw walls; pressed again it lists them. */
function WallTool() {
  const further = editor.value
  const shown = further?.wallTool.value
  const id = shown?.id ?? 'wall'
  const pressed = tool.value === id
  return (
    <IconButton
      icon={shown?.icon ?? BrickWall}
      label={shown?.label ?? t('tools.wall')}
      keys={shown?.keys ?? 'W'}
      pressed={pressed}
      testId="tool-wall"
      list={further ? 'wall-tools' : undefined}
      onClick={(event) => {
        if (!pressed) event.preventDefault()
        else if (!further) withEditor(({ openShapes }) => openShapes())
        tool.value = id
      }}
    />
  )
}

function toolButton({ id, icon, keys }: (typeof TOOLS)[number]) {
  return (
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
  )
}

/** In a place that is kept for them, so that nothing moves when they come: when the browser is idle, or wanted before. */
function MoreTools() {
  const Tools = editor.value?.MoreTools
  const idle = wholeEngine.value === 'here'
  useEffect(() => {
    if (idle) withEditor(() => {})
  }, [idle])
  return <span class="tool-set more-tools">{Tools && <Tools />}</span>
}

export function EditTools() {
  return (
    <div class="toolbar-group edit-tools" role="toolbar" aria-label={t('tools.group')}>
      <div class="tool-set">
        <WallTool />
        {TOOLS.slice(0, 1).map(toolButton)}
        <MoreTools />
        {TOOLS.slice(1).map(toolButton)}
      </div>
      <span class="divider" />
      <UndoButtons of={handUndoing.value ?? OF_MAP} />
    </div>
  )
}
