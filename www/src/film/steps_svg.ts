/** Steps of a race as SVG: one picture in which they appear one after the other, or one picture each. */
import type { Smoothed } from '@pkg/formicarium'
import { FONT, LOOKS } from '../figures/look'
import { endsOf, pathOf } from '../figures/map_marks'
import { imageOf } from '../figures/map_picture'
import { qrElement } from '../figures/qr_code'
import { element, fitting, svgText } from '../figures/svg'
import { contourLines, hatching } from '../figures/terrain_lines'
import { t } from '../i18n/film'
import type { MapPicture } from '../model/messages'
import type { Scenario } from '../model/session'
import { codeWords, reachedWords, titleLines } from './captions'
import type { CopiedRun } from './copied_race'
import { barCorners } from './draw_frame'
import { barOf } from './frame_bar'
import { type FrameLayout, layOut, type Rect } from './frame_layout'
import type { RaceLink } from './link_of_race'
import { titleOfRace } from './make_film'
import type { FilmLook, FilmSize } from './settings'

/** The page's own typeface is not where the file goes: so nothing is measured by it either. */
const PLAIN_FONT = FONT.replace(/^"[^"]*", /, '')
/** Everything is laid out on a sheet whose shorter side has so many units, however large the picture is. */
const SHORTER_SIDE = 720
const CODE_SHARE = 0.3
/** Seconds for which a step is on top, and how many times longer the last one is. */
const STEP_SECONDS = 1.4
const LAST_TIMES = 3

/** What a run's map shows besides its path. */
export interface Seen {
  picture: MapPicture | null
  curve: Smoothed | null
}

const UNSEEN: Seen = { picture: null, curve: null }

/** What the steps of a race have in common. */
export class Sheet {
  private readonly size: FilmSize
  private readonly layout: FrameLayout
  private readonly title = titleLines()
  /** What lies on a terrain besides its cells: hatching below them, contour lines above. */
  private shared: { under: SVGElement | null; over: SVGElement | null } = {
    under: null,
    over: null,
  }

  private constructor(
    private readonly map: Scenario,
    private readonly asked: FilmLook,
    private readonly link: RaceLink,
  ) {
    const fit = SHORTER_SIDE / Math.min(asked.width, asked.height)
    this.size = { width: Math.round(asked.width * fit), height: Math.round(asked.height * fit) }
    this.layout = layOut(this.size, {
      count: asked.panels.length,
      map: map.spec,
      titleLines: this.title.length,
      code: link.code ? CODE_SHARE : 0,
    })
  }

  static async of(map: Scenario, asked: FilmLook, link: RaceLink): Promise<Sheet> {
    const sheet = new Sheet(map, asked, link)
    const { scale } = sheet.placeOf(sheet.layout.panels[0]?.map)
    const lines = await contourLines(map, scale, asked.theme)
    sheet.shared = { under: hatching(map, scale, asked.theme), over: lines?.lines ?? null }
    sheet.shared.under?.setAttribute('id', 'under')
    sheet.shared.over?.setAttribute('id', 'over')
    return sheet
  }

  /** One step, as the runs stand. */
  async step(runs: CopiedRun[], seen: Seen[]): Promise<SVGElement> {
    const look = LOOKS[this.asked.theme]
    const group = element('g', { class: 'step' })
    group.append(element('rect', { ...this.size, fill: look.background }), ...this.titleElements())
    for (const [i, run] of runs.entries()) {
      const place = this.layout.panels[i]
      if (!place) continue
      const bar = i === 0 ? this.barOf(place.caption) : { drawn: [], room: 0 }
      group.append(...this.captionOf(run, place.caption, bar.room), ...bar.drawn)
      group.append(await this.mapOf(run, seen[i] ?? UNSEEN, place.map))
    }
    group.append(...this.codeElements())
    return group
  }

  /** A file with all these steps, each above the one before; or with a single one. */
  file(steps: SVGElement[], name: string): string {
    const { width, height } = this.asked
    const svg = element('svg', {
      xmlns: 'http://www.w3.org/2000/svg',
      role: 'img',
      width,
      height,
      viewBox: `0 0 ${this.size.width} ${this.size.height}`,
      'font-family': PLAIN_FONT,
      fill: LOOKS[this.asked.theme].text,
    })
    svg.append(element('title', {}, name))
    if (this.link.link) svg.append(element('desc', {}, this.link.link))
    const shared = [this.shared.under, this.shared.over].filter((each) => each !== null)
    const copies = shared.map((each) => each.cloneNode(true))
    if (copies.length > 0) svg.append(element('defs', {}, ...copies))
    if (steps.length > 1) svg.append(element('style', {}, motionOf(steps.length)))
    steps.forEach((step, i) => {
      const copy = step.cloneNode(true) as SVGElement
      copy.setAttribute('id', `step-${i + 1}`)
      svg.append(copy)
    })
    return svgText(svg)
  }

  private placeOf(place: Rect | undefined): { scale: number; x: number; y: number } {
    const { width, height } = this.map.spec
    if (!place) return { scale: 1, x: 0, y: 0 }
    const scale = Math.min(place.width / width, place.height / height)
    return {
      scale,
      x: place.x + (place.width - width * scale) / 2,
      y: place.y + (place.height - height * scale) / 2,
    }
  }

  private async mapOf(run: CopiedRun, { picture, curve }: Seen, place: Rect) {
    const { map, asked } = this
    const { width, height } = map.spec
    const { scale, x, y } = this.placeOf(place)
    const group = element('g', { transform: `translate(${x} ${y})` })
    if (this.shared.under) group.append(element('use', { href: '#under' }))
    if (picture) {
      const cells = element('g', { class: 'cells', transform: `scale(${scale})` })
      cells.append(await imageOf(picture.pixels, width, height))
      group.append(cells)
    }
    if (this.shared.over) group.append(element('use', { href: '#over' }))
    const path = run.path.length > 0 ? run.path : null
    const paths = element('g', { class: 'paths', transform: `scale(${scale})` })
    paths.append(...pathOf({ ...run, path }, curve, scale, asked.theme))
    group.append(paths, ...endsOf(map, scale, asked.theme, run.summary.tour?.order ?? []))
    return group
  }

  private titleElements(): SVGElement[] {
    const { title, letter } = this.layout
    return this.title.map((line, i) => {
      const size = i === 0 ? 1.25 * letter : letter
      const weight = i === 0 ? 650 : 400
      const y = title.y + (1.5 * i + 1.1) * letter
      return this.text(line, { x: title.x, y, size, weight, most: title.width, muted: i > 0 })
    })
  }

  /** At the right end of the first caption's second line, and how much of it that takes. */
  private barOf({ x, y, width }: Rect): { drawn: SVGElement[]; room: number } {
    const bar = barOf(this.layout, this.map.spec.width)
    if (!bar) return { drawn: [], room: 0 }
    const { letter } = this.layout
    const size = 0.86 * letter
    // Letters of the reader's typeface may be wider than those of this one.
    const taken = 0.7 * size * bar.words.length + 0.4 * letter
    const right = x + width - taken
    const base = y + 2.3 * letter
    const at = { x: right + 0.4 * letter, y: base, size, weight: 400, most: taken, muted: true }
    const line = element('polyline', {
      class: 'scale-bar',
      points: barCorners(right, base, bar.pixels, letter).join(' '),
      fill: 'none',
      stroke: LOOKS[this.asked.theme].text,
    })
    return { drawn: [line, this.text(bar.words, at)], room: taken + bar.pixels + letter }
  }

  private captionOf(run: CopiedRun, { x, y, width }: Rect, room: number): SVGElement[] {
    const { letter } = this.layout
    const r = 0.36 * letter
    const left = 1.1 * letter
    const name = { x: x + left, y: y + 1.06 * letter, size: letter, weight: 600 }
    const reached = { x, y: y + 2.3 * letter, size: 0.86 * letter, weight: 400 }
    return [
      element('circle', { cx: x + r, cy: y + 0.72 * letter, r, fill: run.colour }),
      this.text(run.name, { ...name, most: width - left, muted: false }),
      this.text(reachedWords(run, null), { ...reached, most: width - room, muted: true }),
    ]
  }

  private codeElements(): SVGElement[] {
    const { code: place, letter } = this.layout
    const { link, code } = this.link
    if (!place || !link || !code) return []
    const { square, words } = place
    const lines = codeWords(this.link).map((line, i) =>
      this.text(line, {
        x: words.x + words.width / 2,
        anchor: 'middle',
        y: words.y + (1.3 + 1.2 * i) * letter,
        size: 0.72 * letter,
        weight: i === 0 ? 600 : 400,
        most: words.width,
        muted: i > 0,
      }),
    )
    return [
      element('a', { href: link }, qrElement(code, square.width, square.x, square.y), ...lines),
    ]
  }

  private text(words: string, at: TextPlace): SVGElement {
    const { x, y, size, weight, most, muted, anchor } = at
    const fill = muted ? { fill: LOOKS[this.asked.theme].muted } : {}
    const shown = fitting(words, most, size, (letters) => `${weight} ${letters}px ${PLAIN_FONT}`)
    const font = { 'font-size': shown.size, 'font-weight': weight, 'text-anchor': anchor }
    return element('text', { x, y, ...font, ...fill }, shown.text)
  }
}

interface TextPlace {
  x: number
  y: number
  size: number
  weight: number
  /** Pixels to which the words are cut. */
  most: number
  muted: boolean
  anchor?: 'middle'
}

/**
 * Each step hides until its time has come; then it lies above those before it. Programs that know no such motion, and readers who want
 * less of it, see the last step.
 */
function motionOf(count: number): string {
  const times = count - 1 + LAST_TIMES
  const whole = (times * STEP_SECONDS).toFixed(1)
  const rules = Array.from({ length: count - 1 }, (_, i) => {
    const from = ((100 * (i + 1)) / times).toFixed(3)
    const id = `step-${i + 2}`
    return [
      `@keyframes ${id}{0%{visibility:hidden}${from}%,100%{visibility:visible}}`,
      `#${id}{animation:${id} ${whole}s step-end infinite}`,
    ].join('')
  })
  return `${rules.join('')}@media (prefers-reduced-motion:reduce){.step{animation:none!important}}`
}

/** The name of one of several steps. */
export const stepName = (step: number, steps: number) =>
  `${titleOfRace()} · ${t('film.step', { step, steps })}`
