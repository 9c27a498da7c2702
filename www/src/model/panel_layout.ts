/** How panels share the room: so that their maps come out as large as they can. All lengths in CSS pixels. */
import type { Size } from './viewpoint'

/** What of a panel is no map: the height of its head, and its borders; and what lies between panels. */
export interface PanelFrame {
  head: number
  border: number
  gap: number
}

export interface PanelLayout {
  columns: number
  /** Of every row, where the panels are more than the room holds and are scrolled; null where the rows share its height. */
  rowHeight: number | null
}

/** A smaller map would be of no use. */
const LEAST: Size = { width: 250, height: 130 }
/** Where single cells are pressed: rather scrolled than too small for a finger. */
const LEAST_PRESSED: Size = { width: 300, height: 200 }
/** Panels that are scrolled are at least so wide. */
const SCROLLED_WIDTH = 320
const LEAST_SCROLLED = 160

/** `pressed`: whether single cells of the maps are about to be pressed. */
export function panelLayout(
  count: number,
  room: Size,
  map: Size,
  frame: PanelFrame,
  pressed = false,
): PanelLayout {
  let best = { columns: 1, scale: -1, stage: stageSize(1, count, room, frame) }
  for (let columns = 1; columns <= count; columns++) {
    const stage = stageSize(columns, count, room, frame)
    const scale = Math.min(stage.width / map.width, stage.height / map.height)
    if (scale > best.scale) best = { columns, scale, stage }
  }
  const { columns, stage } = best
  const least = pressed ? LEAST_PRESSED : LEAST
  const fits = stage.width >= least.width && stage.height >= least.height
  return fits || count === 1 ? { columns, rowHeight: null } : scrolled(count, room, map, frame)
}

/** What a panel's stage measures when the rows share the height. */
function stageSize(columns: number, count: number, room: Size, frame: PanelFrame): Size {
  const rows = Math.ceil(count / columns)
  return {
    width: (room.width - frame.gap * (columns - 1)) / columns - frame.border,
    height: (room.height - frame.gap * (rows - 1)) / rows - frame.head - frame.border,
  }
}

/** Rows as high as the map wants, and no higher than the room. */
function scrolled(count: number, room: Size, map: Size, frame: PanelFrame): PanelLayout {
  const fitting = Math.floor((room.width + frame.gap) / (SCROLLED_WIDTH + frame.gap))
  const columns = Math.min(count, Math.max(1, fitting))
  const { width } = stageSize(columns, count, room, frame)
  const wanted = (width * map.height) / map.width
  const most = Math.max(LEAST_SCROLLED, room.height - frame.head - frame.border)
  const stage = Math.min(most, Math.max(LEAST_SCROLLED, wanted))
  return { columns, rowHeight: Math.floor(stage + frame.head + frame.border) }
}
