/** The map with paths, ends and layer, as a picture that stands alone. */

import type { Smoothed } from '@pkg/formicarium'
import { lateTools } from '../engine/late_tools'
import { client } from '../engine/panel_clients'
import { numbers } from '../i18n'
import { t } from '../i18n/pictures'
import { addWeightWords, t as tOfWeights } from '../i18n/weights'
import type { MapPicture } from '../model/messages'
import { heightRange } from '../model/relief_ground'
import type { Scenario } from '../model/session'
import { DEAREST, PLAIN } from '../model/weights'
import { hasNarrow, isDear, isDearer } from '../stage/felt_ground'
import { BLOCKED, FREE } from '../stage/layer_colours'
import { layer, layerEnds, panels, scenario, shownOf } from '../state'
import { layerNumber, layerTitle } from '../words/layer_words'
import { barScale } from '../words/metres'
import { type CellPaths, cellPaths } from './map_cells'
import { KEYS_HEIGHT, keysOf, type Ramp } from './map_keys'
import { endsOf, pathOf } from './map_marks'
import { blobOf } from './picture_files'
import {
  type Ground,
  headingOf,
  lookOf,
  type Picture,
  type Runner,
  runners,
  themeOf,
  WIDTH,
} from './race_parts'
import { element } from './svg'
import { contourLines, hatching } from './terrain_lines'

/** Pixels. */
const TALLEST = 720
/** Rectangles beyond which the cells are a picture inside the picture: as text they would be a file of megabytes. */
const MOST_RECTANGLES = 40_000

/** Whose path and layer: of one panel, or the paths of all on the bare map. */
export type Whose = number | 'all'

/** Null while no run has been loaded. */
export async function mapPicture(ground: Ground, whose: Whose): Promise<Picture | null> {
  const now = scenario.peek()
  const panelId = whose === 'all' ? panels.peek()[0]?.id : whose
  if (!now || panelId === undefined) return null
  await addWeightWords()
  const theme = themeOf(ground)
  const { width, height } = now.spec
  const wanted = whose === 'all' ? 'none' : layer.peek()
  const worker = client(panelId)
  const look = { layer: wanted, ends: layerEnds.peek(), theme }
  const painted = await worker?.ask({ about: 'picture', size: [width, height], ...look })
  if (!painted) return null
  const ramps = await rampsOf(now, painted, theme)
  if (ground === 'print') whiten(painted.pixels, await lateTools.mapColours('none', theme))
  const shown = runners().filter(({ panel }) => whose === 'all' || panel.id === whose)
  return pictureOf(now, painted, ramps, shown, ground)
}

async function pictureOf(
  now: Scenario,
  painted: MapPicture,
  ramps: Ramp[],
  shown: Runner[],
  colours: Ground,
): Promise<Picture> {
  const { width, height } = now.spec
  const scale = Math.min(WIDTH / width, TALLEST / height)
  const theme = themeOf(colours)
  const look = lookOf(colours)
  const vectors = cellPaths(painted.pixels, width, MOST_RECTANGLES)
  const cells = element('g', { class: 'cells', transform: `scale(${scale})` })
  if (vectors) drawCells(cells, vectors, width, height)
  else cells.append(await imageOf(painted.pixels, width, height))
  const paths = element('g', { class: 'paths', transform: `scale(${scale})` })
  for (const runner of shown) paths.append(...pathOf(runner, await curveOf(runner), scale, theme))
  const order = shown.length === 1 && shown[0] ? shownOf(shown[0].panel).summary?.tour?.order : []
  const contours = await contourLines(now, scale, theme)
  const frame = { width: width * scale, height: height * scale, fill: 'none', stroke: look.line }
  const under = hatching(now, scale, theme)
  const ground = [under, cells, contours?.lines ?? null].filter((each) => each !== null)
  const plot = element('g', {}, ...ground, element('rect', frame), paths)
  plot.append(...endsOf(now, scale, theme, order ?? []))
  const counted = barScale.peek()
  const keys = keysOf(ramps, counted === null ? null : counted / scale, look)
  const tall = Math.ceil(height * scale) + 12
  if (keys) plot.append(element('g', { transform: `translate(0 ${tall})` }, keys))
  const what = t('pictures.kinds.map')
  return {
    drawing: {
      plot,
      height: tall + (keys ? KEYS_HEIGHT : 0),
      legend: shown.map(({ label, colour }) => ({ kind: 'line', label, colour, width: 3 })),
      notes: notesOf(vectors !== null, contours?.interval ?? null, under !== null),
    },
    heading: headingOf(what),
    words: `${what}. ${shown.map(({ label }) => label).join('; ')}`,
    look,
  }
}

async function curveOf({ panel }: Runner): Promise<Smoothed | null> {
  return (await client(panel.id)?.ask({ about: 'curve' }))?.curve ?? null
}

function notesOf(isVectors: boolean, interval: number | null, hasHoles: boolean): string[] {
  const notes = isVectors ? [] : [t('pictures.cellsArePicture')]
  const value = interval === null ? '' : numbers.peek().metres.format(interval)
  if (value) notes.push(t('pictures.contours', { interval: t('lengths.metres', { value }) }))
  if (hasHoles) notes.push(t('pictures.noData'))
  if (hasNarrow.peek()) notes.push(tOfWeights('weights.picture'))
  return notes
}

function drawCells(onto: SVGElement, { base, paths }: CellPaths, width: number, height: number) {
  // Neighbours would show seams where they are smoothed.
  onto.setAttribute('shape-rendering', 'crispEdges')
  if (base) onto.append(element('rect', { width, height, fill: base }))
  for (const { colour, d } of paths) onto.append(element('path', { d, fill: colour }))
}

/** Cells as one picture, a pixel each. */
export async function imageOf(
  pixels: MapPicture['pixels'],
  width: number,
  height: number,
): Promise<SVGElement> {
  const canvas = document.createElement('canvas')
  Object.assign(canvas, { width, height })
  canvas.getContext('2d')?.putImageData(new ImageData(pixels, width, height), 0, 0)
  const bytes = new Uint8Array(await (await blobOf(canvas)).arrayBuffer())
  let text = ''
  for (let i = 0; i < bytes.length; i += 8192)
    text += String.fromCharCode(...bytes.subarray(i, i + 8192))
  const href = `data:image/png;base64,${btoa(text)}`
  return element('image', { width, height, href, 'image-rendering': 'pixelated' })
}

/** A free cell is as white as the paper. */
function whiten(pixels: Uint8ClampedArray, colours: Uint8Array): void {
  const [red, green, blue] = colours.subarray(3 * FREE, 3 * BLOCKED)
  for (let i = 0; i < pixels.length; i += 4)
    if (pixels[i] === red && pixels[i + 1] === green && pixels[i + 2] === blue)
      pixels.fill(255, i, i + 3)
}

async function rampsOf(
  now: Scenario,
  { scale: { layer: shown, own } }: MapPicture,
  theme: ReturnType<typeof themeOf>,
): Promise<Ramp[]> {
  const ramps: Ramp[] = []
  const ends = shown === 'none' ? null : (layerEnds.peek()[shown] ?? own)
  if (shown !== 'none' && ends) {
    const [low = '', high = ''] = ends.map(layerNumber(shown))
    const colours = await lateTools.mapColours(shown, theme)
    ramps.push({ id: 'layer', title: layerTitle(shown), low, high, colours })
  }
  if (isDear.peek()) ramps.push(await weightsRamp(theme))
  const heights = heightRange(now)
  if (heights) {
    const metres = (value: number) =>
      t('lengths.metres', { value: numbers.peek().metres.format(value) })
    const [low = '', high = ''] = heights.map(metres)
    const colours = await lateTools.mapColours('none', theme)
    ramps.push({ id: 'heights', title: t('legend.heights'), low, high, colours })
  }
  return ramps
}

async function weightsRamp(theme: ReturnType<typeof themeOf>): Promise<Ramp> {
  const [low, high] = [PLAIN, DEAREST].map((factor) => tOfWeights('weights.times', { factor }))
  return {
    id: 'weights',
    title: tOfWeights('weights.legend'),
    low: low ?? '',
    high: isDearer.peek() ? tOfWeights('weights.orMore', { factor: DEAREST }) : (high ?? ''),
    colours: await lateTools.weightColours(theme),
  }
}
