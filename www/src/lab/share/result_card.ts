/** A picture of the results. The comparison itself is embedded in the file, so that the picture can be opened here. */

import { FONT, LOOKS, type Look } from '../../figures/look'
import { shortened, wrapped } from '../../figures/svg'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import type { Analysis, EntryAnalysis, MapAnalysis } from '../../model/analysis'
import { pngWith } from '../../share/png'
import { engineVersion } from '../../state'
import { seriesOf } from '../figures/figure_style'
import { openComparison, progress } from '../run/actions'
import { shownAnalysis, shownComparison } from '../store/shown_comparison'
import { amount, labelOf, measureWords, range } from '../words/numbers'
import { embedComparison } from './embed_comparison'

const WIDTH = 1200
const EDGE = 48
const LINE = 66
const HEAD = 30
/** As much as can be read on a phone's screen. */
const MOST_MAPS = 3
const MOST_ENTRIES = 12
const NAMES = 380

type Context = CanvasRenderingContext2D

/** The results, with the comparison in the picture. */
export const resultCard = async (): Promise<Blob> =>
  embedComparison(await drawn(t('lab.share.cardFooter')))

/** The results so far, with the journal of a share in the picture. */
export async function shareCard(journal: string): Promise<Uint8Array> {
  const picture = await drawn(t('lab.class.cardFooter'))
  return pngWith(new Uint8Array(await picture.arrayBuffer()), journal)
}

async function drawn(footer: string): Promise<Blob> {
  const canvas = document.createElement('canvas')
  canvas.width = WIDTH
  canvas.height = heightOf(shownAnalysis.peek())
  const context = canvas.getContext('2d')
  if (context) draw(context, canvas.height, LOOKS.light, footer)
  const png = await new Promise<Blob | null>((done) => canvas.toBlob(done, 'image/png'))
  if (!png) throw new Error('the browser makes no picture')
  return png
}

const titleLines = () =>
  wrapped(shownComparison.peek()?.title ?? '', WIDTH - 2 * EDGE, font(650, 34)).slice(0, 2)

function heightOf(found: Analysis | null): number {
  const entries = Math.min(MOST_ENTRIES, found?.instances[0]?.entries.length ?? 0)
  const more = (found?.instances[0]?.entries.length ?? 0) > MOST_ENTRIES ? 1 : 0
  const table = found ? 2 * HEAD + (entries + more) * LINE : 0
  return 2 * EDGE + titleLines().length * 42 + 40 + table + 60
}

function draw(context: Context, height: number, look: Look, footer: string): void {
  context.fillStyle = look.background
  context.fillRect(0, 0, WIDTH, height)
  let y = EDGE + 26
  for (const line of titleLines()) {
    write(context, line, EDGE, y, font(650, 34), look.text)
    y += 42
  }
  write(context, subtitle(), EDGE, y, font(400, 20), look.muted)
  const found = shownAnalysis.peek()
  if (found) table(context, found, y + 52, look)
  rule(context, height - EDGE - 24, look)
  write(context, `Formicarium · ${footer}`, EDGE, height - EDGE + 8, font(400, 18), look.muted)
}

function subtitle(): string {
  const now = openComparison.peek()
  if (!now) return ''
  const { instances, entries, seeds } = now.question
  return [
    t('lab.share.carriesMaps', { count: instances.length }),
    t('lab.share.carriesEntries', { count: entries.length }),
    t('lab.share.carriesSeeds', { count: seeds.count }),
    t('lab.share.cardRuns', {
      runs: numbers.value.whole.format(progress.peek().done),
      engine: engineOf(),
    }),
  ].join(' · ')
}

/** The engine that did the runs: the recorded one, or this one. */
function engineOf(): string {
  const now = openComparison.peek()
  return (now?.runs === 'file' && now.recorded?.engine) || engineVersion.peek()
}

function table(context: Context, { instances }: Analysis, top: number, look: Look): void {
  const maps = instances.slice(0, MOST_MAPS)
  const column = (WIDTH - 2 * EDGE - NAMES) / Math.max(1, maps.length)
  const left = (at: number) => EDGE + NAMES + at * column
  write(context, t('lab.share.cardEntry'), EDGE, top, font(650, 17), look.muted)
  for (const [at, map] of maps.entries()) heading(context, map, left(at), top, column, look)
  const more = instances.length - maps.length
  if (more > 0)
    write(
      context,
      t('lab.share.cardMoreMaps', { count: more }),
      EDGE,
      top + 24,
      font(400, 16),
      look.muted,
    )
  let y = top + 2 * HEAD
  const all = instances[0]?.entries ?? []
  for (const [place, entry] of all.slice(0, MOST_ENTRIES).entries()) {
    rule(context, y - 24, look)
    dot(context, EDGE + 8, y, seriesOf(place, '').colour)
    const words = shortened(labelOf(entry), NAMES - 44, font(600, 19))
    write(context, words, EDGE + 26, y + 7, font(600, 19), look.text)
    for (const [at, map] of maps.entries())
      cell(context, map, map.entries[place], left(at), y + 7, look)
    y += LINE
  }
  if (all.length > MOST_ENTRIES)
    write(
      context,
      t('lab.share.cardMore', { count: all.length - MOST_ENTRIES }),
      EDGE + 26,
      y + 7,
      font(400, 17),
      look.muted,
    )
}

function heading(
  context: Context,
  map: MapAnalysis,
  x: number,
  y: number,
  width: number,
  look: Look,
): void {
  const name = shortened(map.name || map.id, width - 16, font(650, 17))
  write(context, name, x, y, font(650, 17), look.text)
  const measure = t('lab.share.cardMedian', { measure: measureWords(map.measure) })
  write(
    context,
    shortened(measure, width - 16, font(400, 16)),
    x,
    y + 24,
    font(400, 16),
    look.muted,
  )
}

function cell(
  context: Context,
  map: MapAnalysis,
  entry: EntryAnalysis | undefined,
  x: number,
  y: number,
  look: Look,
): void {
  const { summary = null, with_path = 0, runs = 0 } = entry ?? {}
  if (!summary) {
    const words = runs === 0 ? '–' : t('lab.share.cardNone')
    write(context, words, x, y, font(400, 19), runs === 0 ? look.muted : look.bad)
    return
  }
  const value = amount(map.measure)
  write(context, value(summary.median), x, y, font(650, 20), look.text)
  const spread = range(summary.lower, summary.upper, value)
  const paths =
    with_path < runs ? ` · ${t('lab.share.cardPaths', { part: with_path, whole: runs })}` : ''
  write(context, spread + paths, x, y + 22, font(400, 15), look.muted)
}

const font = (weight: number, size: number) => `${weight} ${size}px ${FONT}`

function write(
  context: Context,
  words: string,
  x: number,
  y: number,
  style: string,
  colour: string,
): void {
  context.font = style
  context.fillStyle = colour
  context.fillText(words, x, y)
}

function rule(context: Context, y: number, look: Look): void {
  context.fillStyle = look.line
  context.fillRect(EDGE, y, WIDTH - 2 * EDGE, 1)
}

function dot(context: Context, x: number, y: number, colour: string): void {
  context.fillStyle = colour
  context.beginPath()
  context.arc(x, y, 7, 0, 2 * Math.PI)
  context.fill()
}
