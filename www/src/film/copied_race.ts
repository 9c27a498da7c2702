/** The race once more, from its beginning: copies of its runs that go on together, and are held against the runs on the page. */
import type { RunSummary } from '@pkg/formicarium'
import type { PanelView } from '../model/messages'
import type { Scenario } from '../model/session'
import { type Panel, panelById, referenceOf, scenario, slotColour } from '../state'
import { BEST_SO_FAR, ROW } from '../state/history_rows'
import { runSetup } from '../state/runs'
import { gapOf } from '../words/gap_words'
import { isSearch, panelTitle } from '../words/planner_words'
import { RunCopy } from './run_copy'
import type { Filmed, Moment, Unit } from './settings'

/** One run of the race, as it stands in the copy. */
export interface CopiedRun {
  panel: Panel
  name: string
  colour: string
  /** Searches have no iterations that say anything. */
  isSearch: boolean
  summary: RunSummary
  path: Uint32Array
  gap: number | null
}

/** Whether the copies have become what the page has: so far nothing could be compared, the same bits, or other ones. */
export type Agreement = 'unknown' | 'same' | 'differs'

export class CopiedRace {
  agreement: Agreement = 'unknown'
  /** Iterations at whose end some run had a better path than before. */
  readonly improved = new Set<number>()
  private readonly lanes: Lane[]
  private moved = 0

  private constructor(
    readonly map: Scenario,
    filmed: Filmed[],
  ) {
    this.lanes = filmed.flatMap(({ id, reached }) => {
      const panel = panelById(id)
      return panel ? [new Lane(panel, reached, this.improved)] : []
    })
  }

  /** Loads the runs of these panels; null where there are none. */
  static async of(filmed: Filmed[]): Promise<CopiedRace | null> {
    const map = scenario.peek()
    const race = map && new CopiedRace(map, filmed)
    if (!race || race.lanes.length === 0) return null
    try {
      await Promise.all(race.lanes.map((lane) => lane.load(map)))
    } catch (error) {
      race.end()
      throw error
    }
    return race
  }

  /** The runs as they stand. */
  runs(): CopiedRun[] {
    return this.lanes.flatMap((lane) => lane.standing() ?? [])
  }

  /** Goes on to a moment, which must not lie before the present one. */
  async goTo({ at, last }: Pick<Moment, 'at' | 'last'>, unit: Unit): Promise<void> {
    if (unit === 'iteration')
      await Promise.all(this.lanes.map((lane) => lane.toIteration(lane.due(at, last))))
    else await this.moveTo(at)
    const compared = this.lanes.map(({ agrees }) => agrees)
    if (compared.includes(false)) this.agreement = 'differs'
    else if (compared.every((agrees) => agrees === true)) this.agreement = 'same'
  }

  shots(views: PanelView[], glide: number): Promise<ImageBitmap[]> {
    const wanted = this.lanes.flatMap((lane, i) => (views[i] ? [{ lane, view: views[i] }] : []))
    return Promise.all(wanted.map(({ lane, view }) => lane.copy.shot(view, glide)))
  }

  /** The map of each run with a layer, one pixel a cell, and the smooth curve of its path. */
  seen(look: Pick<PanelView, 'layer' | 'ends' | 'theme'>) {
    const { width, height } = this.map.spec
    return Promise.all(
      this.lanes.map(async ({ copy }) => ({
        picture: await copy.picture(look, [width, height]),
        curve: await copy.curve(),
      })),
    )
  }

  end(): void {
    for (const { copy } of this.lanes) copy.end()
  }

  /** One by one: that is how ants are told apart from move to move. */
  private async moveTo(at: number): Promise<void> {
    for (; this.moved < at; this.moved++) await Promise.all(this.lanes.map((lane) => lane.move()))
  }
}

/** The column of a row of history that has its iteration. */
const ITERATION = 0

/** A copy, and where the run that it was made of stands on the page. */
class Lane {
  readonly copy: RunCopy
  agrees: boolean | null = null
  private readonly reference
  private best = Number.POSITIVE_INFINITY

  constructor(
    private readonly panel: Panel,
    private readonly reached: Filmed['reached'],
    private readonly improved: Set<number>,
  ) {
    this.reference = referenceOf(panel)
    this.copy = new RunCopy((rows) => this.note(rows))
  }

  load(map: Scenario) {
    return this.copy.load(runSetup(this.panel, map))
  }

  /** Searches count contours, of which they may have many more than a colony has iterations: they end as they stand on the page. */
  due(iteration: number, last: boolean): number {
    const wanted = last && isSearch(this.panel.setup.planner) ? this.reached?.iteration : 0
    return Math.max(iteration, wanted ?? 0)
  }

  async toIteration(iteration: number): Promise<void> {
    const { reached } = this
    if (this.agrees === null && reached && reached.iteration <= iteration) {
      await this.copy.advance({ kind: 'until-iteration', iteration: reached.iteration })
      this.compare()
    }
    await this.copy.advance({ kind: 'until-iteration', iteration })
  }

  async move(): Promise<void> {
    await this.copy.advance({ kind: 'moves', count: 1 })
    this.compare()
  }

  /** A digest is of finished iterations, so it holds until the next one ends. */
  private compare(): void {
    const summary = this.copy.frame?.summary
    if (this.agrees === null && this.reached && summary?.iteration === this.reached.iteration)
      this.agrees = summary.digest === this.reached.digest
  }

  standing(): CopiedRun | null {
    const summary = this.copy.frame?.summary
    if (!summary) return null
    const { panel, copy } = this
    return {
      panel,
      name: panelTitle(panel.id),
      colour: slotColour(panel.slot),
      isSearch: isSearch(panel.setup.planner),
      summary,
      path: copy.path,
      gap: gapOf(summary.value, this.reference),
    }
  }

  private note(rows: Float64Array): void {
    for (let at = 0; at < rows.length; at += ROW) {
      const best = rows[at + BEST_SO_FAR] ?? Number.NaN
      if (!(best < this.best)) continue
      this.best = best
      this.improved.add(rows[at + ITERATION] ?? 0)
    }
  }
}
