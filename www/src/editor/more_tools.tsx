/** The further tools in the row: how wide the brush is, what selects, and the lists that belong to buttons. */
import { computed, signal } from '@preact/signals'
import {
  BrickWall,
  ClipboardPaste,
  Copy,
  Eraser,
  FlipHorizontal2,
  FlipVertical2,
  type IconNode,
  PaintBucket,
  RotateCcwSquare,
  RotateCwSquare,
  Scissors,
  SquareDashed,
  SquareX,
} from 'lucide'
import { t } from '../i18n/editor'
import { TURNS, type Turn } from '../model/turn'
import { tool } from '../state'
import { IconButton } from '../ui/buttons'
import { Menu, MenuHeading, MenuItem } from '../ui/menu'
import { BLOCK, LINE, RECTANGLE } from './draw_icons'
import { GroundTool } from './ground_tool'
import {
  brushSize,
  isWallTool,
  lastWallTool,
  SIZES,
  setBrushSize,
  straight,
  WALL_TOOLS,
  type WallTool,
} from './hand'
import { canPaste, copy, cut, free, paste, selection, turn, unselect } from './selection'
import { isShape } from './shapes'
import { ToolList } from './tool_list'

const ANGLE: IconNode = [['path', { d: 'M4 19h16M4 19 17 6' }]]
const ICONS: Record<WallTool, IconNode> = {
  wall: BrickWall,
  line: LINE,
  rectangle: RECTANGLE,
  block: BLOCK,
  fill: PaintBucket,
}
/** The library names them by the line between the halves, the tools by what changes places. */
const TURN_ICONS: Record<Turn, IconNode> = {
  left: RotateCcwSquare,
  right: RotateCwSquare,
  mirror: FlipVertical2,
  flip: FlipHorizontal2,
}
const KEYS: Record<WallTool, string> = {
  wall: 'W',
  line: 'L',
  rectangle: 'B',
  block: 'N',
  fill: 'D',
}

/** What the button for walls shows. */
export const wallTool = computed(() => {
  const id = lastWallTool.value
  const label = id === 'wall' ? t('tools.wall') : t(`editor.tools.${id}`)
  const again = tool.value === id
  return {
    id,
    icon: ICONS[id],
    keys: KEYS[id],
    label: again ? t('editor.more', { tool: label }) : label,
  }
})

const openAtOnce = signal(false)

/** The button for walls was pressed again before these tools had been fetched. */
export function openShapes(): void {
  openAtOnce.value = true
}

export function MoreTools() {
  return (
    <>
      <ShapeList />
      <SizeMenu />
      <GroundTool />
      <SelectTool />
    </>
  )
}

function ShapeList() {
  return (
    <ToolList id="wall-tools" label={t('editor.shapes')} open={openAtOnce.peek()}>
      {WALL_TOOLS.map((id) => (
        <MenuItem
          key={id}
          icon={ICONS[id]}
          label={`${t(`editor.tools.${id}`)} · ${KEYS[id]}`}
          note={t(`editor.notes.${id}`)}
          checked={isWallTool(tool.value) && lastWallTool.value === id}
          testId={`shape-${id}`}
          onClick={() => {
            tool.value = id
          }}
        />
      ))}
      <MenuItem
        toggle
        icon={ANGLE}
        label={t('editor.straight')}
        note={t('editor.straightNote')}
        checked={straight.value}
        testId="shape-straight"
        onClick={toggleStraight}
      />
    </ToolList>
  )
}

/** Whoever wants straight lines wants to draw one. */
function toggleStraight(): void {
  straight.value = !straight.peek()
  if (straight.peek() && !isShape(lastWallTool.peek())) tool.value = 'line'
}

function SizeMenu() {
  const size = brushSize.value
  return (
    <Menu
      bare
      label={t('editor.size', { size: t('editor.sizeOption', { count: size }) })}
      testId="brush-size"
      face={<span class="size-face">{size}</span>}
    >
      <MenuHeading text={`${t('editor.sizes')} · J, K`} />
      {SIZES.map((option) => (
        <MenuItem
          key={option}
          label={t('editor.sizeOption', { count: option })}
          checked={option === size}
          testId={`size-${option}`}
          onClick={() => setBrushSize(option)}
        />
      ))}
    </Menu>
  )
}

function SelectTool() {
  const chosen = tool.value === 'select'
  const label = t('editor.tools.select')
  return (
    <>
      <IconButton
        icon={SquareDashed}
        label={chosen ? t('editor.more', { tool: label }) : t('editor.actions')}
        keys="M"
        pressed={chosen}
        testId="tool-select"
        list="select-tools"
        onClick={(event) => {
          if (!chosen) event.preventDefault()
          tool.value = 'select'
        }}
      />
      <ToolList id="select-tools" label={t('editor.actions')}>
        <TurnItems />
        <SelectionItems />
      </ToolList>
    </>
  )
}

function TurnItems() {
  return (
    <>
      <MenuHeading text={t(selection.value ? 'editor.turnSelection' : 'editor.turnMap')} />
      {TURNS.map((id) => (
        <MenuItem
          key={id}
          icon={TURN_ICONS[id]}
          label={t(`editor.turns.${id}`)}
          testId={`turn-${id}`}
          onClick={() => turn(id)}
        />
      ))}
    </>
  )
}

function SelectionItems() {
  return (
    <>
      {selection.value && (
        <>
          <MenuItem
            icon={Copy}
            label={`${t('editor.copy')} · Ctrl+C`}
            testId="selection-copy"
            onClick={copy}
          />
          <MenuItem
            icon={Scissors}
            label={`${t('editor.cutOut')} · Ctrl+X`}
            testId="selection-cut"
            onClick={cut}
          />
          <MenuItem
            icon={Eraser}
            label={`${t('editor.free')} · Delete`}
            testId="selection-free"
            onClick={free}
          />
          <MenuItem
            icon={SquareX}
            label={`${t('editor.leave')} · Esc`}
            testId="selection-leave"
            onClick={unselect}
          />
        </>
      )}
      {canPaste.value && (
        <MenuItem
          icon={ClipboardPaste}
          label={`${t('editor.paste')} · Ctrl+V`}
          testId="selection-paste"
          onClick={() => paste(null)}
        />
      )}
    </>
  )
}
