/** What a panel's worker answers about its run besides frames: looking back, the moves of a cell, a layer's values. */
import type { Run as CoreRun } from '@pkg/core/formicarium'
import type { Run as WholeRun } from '@pkg/formicarium'
import type { PanelAnswers, PanelQuestion } from '../model/messages'
import { certificateOf } from './certificate'
import { curveOf, forgetCurve } from './curve'
import type { Painter } from './painter'
import { paintLayer } from './shown_layer'

/** Fetched together: neither is needed before somebody asks or stops. */
export { StopWatch } from './stop_watch'

/** A run of either build of the engine. */
type Run = CoreRun &
  Partial<
    Pick<
      WholeRun,
      'level_at' | 'change_walls' | 'show_walls' | 'adapts' | 'smoothed' | 'certificate'
    >
  >

interface Asked {
  /** False once the run has been replaced or, of a look, once another one is wanted. */
  isCurrent(): boolean
  painter: Painter | null
}

type Answer = PanelAnswers[keyof PanelAnswers] | null

/** Iterations are repeated in slices, so that the worker hears in between when another one is wanted. */
const SLICE_MS = 12
const MOST_AT_ONCE = 4096

export async function answer(question: PanelQuestion, run: Run, asked: Asked): Promise<Answer> {
  if (!asked.isCurrent()) return null
  switch (question.about) {
    case 'look':
      return look(question.iteration, run, asked)
    case 'moves': {
      const [x, y] = question.cell
      // The core of the engine knows no levels.
      const level = question.level ?? run.level_at?.(x, y) ?? 0
      return { level, rows: run.moves_from(x, y, level) }
    }
    case 'layer':
      return run.layer(question.layer)
    case 'curve':
      return curveOf(run)
    case 'certificate':
      return certificateOf(run)
    case 'kept':
      return keptOf(run)
    case 'picture':
      return pictureOf(question, run)
    case 'shot':
      return asked.painter && shot(question, asked.painter)
    case 'walls': {
      const at = run.change_walls?.(question.walls) ?? null
      forgetCurve()
      return { at, adapts: run.adapts?.() ?? null, ...shown(run, asked) }
    }
    case 'show-walls':
      run.show_walls?.(question.walls)
      forgetCurve()
      shown(run, asked)
      return null
  }
}

function pictureOf(look: Extract<PanelQuestion, { about: 'picture' }>, run: Run): Answer {
  const [width, height] = look.size
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })
  if (context === null) return null
  const scale = paintLayer(run, context, look, true)
  return { pixels: context.getImageData(0, 0, width, height).data, scale }
}

/** Of a panel that nobody sees, and that stays so. */
function shot(
  { view, glide }: Extract<PanelQuestion, { about: 'shot' }>,
  painter: Painter,
): ImageBitmap {
  painter.view = view
  painter.glide = glide
  painter.draw()
  painter.view = { ...view, hidden: true }
  return painter.canvas.transferToImageBitmap()
}

function keptOf(run: Run): PanelAnswers['kept'] {
  const [snapshots = 0, bytes = 0, , , mostRepeated = 0] = run.snapshots()
  return { snapshots, bytes, mostRepeated }
}

async function look(iteration: number | null, run: Run, asked: Asked): Promise<Answer> {
  return (await goBack(iteration, run, asked)) ? shown(run, asked) : null
}

/** What the run answers now, drawn as well. */
function shown(run: Run, { painter }: Asked): PanelAnswers['look'] {
  const look = {
    summary: run.summary(),
    bestPath: run.best_path(),
    bestAltitudes: run.best_altitudes(),
  }
  painter?.setPath(look.bestPath)
  painter?.setOrder(look.summary.tour?.order ?? [])
  painter?.refresh(false)
  return look
}

/** Goes there slice by slice; false when it is not wanted any more. */
async function goBack(iteration: number | null, run: Run, asked: Asked): Promise<boolean> {
  let atOnce = 1
  for (;;) {
    const began = performance.now()
    if (run.show_iteration(iteration, atOnce)) return true
    const took = performance.now() - began
    if (took < SLICE_MS / 2) atOnce = Math.min(MOST_AT_ONCE, 2 * atOnce)
    else if (took > SLICE_MS) atOnce = Math.max(1, atOnce >> 1)
    if (took > SLICE_MS / 4) await new Promise((resolve) => setTimeout(resolve))
    if (!asked.isCurrent()) return false
  }
}
