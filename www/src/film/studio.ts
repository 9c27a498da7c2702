/** Draws the frames of a film, each for its moment of a copied race, in order. */
import { FONT } from '../figures/look'
import { codeWords, reachedWords, titleLines } from './captions'
import type { CopiedRace } from './copied_race'
import { type Canvas, drawFrame, type FrameWords, viewOf } from './draw_frame'
import { barOf } from './frame_bar'
import { type FrameLayout, layOut } from './frame_layout'
import type { RaceLink } from './link_of_race'
import { type FilmSettings, type Moment, momentOf } from './settings'

/** At the end of a film a code takes half of the frame. */
const END_SHARE = 0.5

export class Studio {
  readonly canvas: OffscreenCanvas
  private readonly context: Canvas
  private readonly plain: FrameLayout
  private readonly withCode: FrameLayout
  private readonly title = titleLines()
  private drawn = ''

  private constructor(
    private readonly race: CopiedRace,
    private readonly settings: FilmSettings,
    private readonly link: RaceLink,
  ) {
    this.canvas = new OffscreenCanvas(settings.width, settings.height)
    const context = this.canvas.getContext('2d', { alpha: false })
    if (!context) throw new Error('the browser makes no picture')
    this.context = context
    const { width, height } = race.map.spec
    const asked = {
      count: race.runs().length,
      map: { width, height },
      titleLines: this.title.length,
    }
    this.plain = layOut(settings, { ...asked, code: 0 })
    this.withCode = layOut(settings, { ...asked, code: END_SHARE })
  }

  static async of(race: CopiedRace, settings: FilmSettings, link: RaceLink): Promise<Studio> {
    await Promise.all(
      [400, 600, 650].map((weight) => document.fonts.load(`${weight} 20px ${FONT}`)),
    )
    return new Studio(race, settings, link)
  }

  /** Takes the race to the moment of a frame and draws it; a frame that shows the same as the one before is left as it is. */
  async draw(frame: number): Promise<void> {
    const moment = momentOf(frame, this.settings)
    const key = JSON.stringify(moment)
    if (key === this.drawn) return
    this.drawn = key
    const { settings, race } = this
    await race.goTo(moment, settings.unit)
    const layout = moment.code ? this.withCode : this.plain
    const maps = await race.shots(
      race.runs().map((run, i) => {
        const place = layout.panels[i]?.map ?? { x: 0, y: 0, width: 1, height: 1 }
        return viewOf(run, race.map, settings, place, settings.unit === 'move')
      }),
      moment.glide,
    )
    try {
      const { code } = this.link
      drawFrame(this.context, layout, settings.theme, maps, this.words(moment, layout), code)
    } finally {
      for (const map of maps) map.close()
    }
  }

  private words(moment: Moment, layout: FrameLayout): FrameWords {
    const moves = this.settings.unit === 'move' ? moment.at : null
    const panels = this.race
      .runs()
      .map((run) => ({ name: run.name, colour: run.colour, reached: reachedWords(run, moves) }))
    const bar = barOf(layout, this.race.map.spec.width)
    return { title: this.title, panels, bar, code: codeWords(this.link) }
  }
}
