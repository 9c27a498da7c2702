/** Makes steps of the race, as SVG: from a copy of its runs, at iterations that are spread evenly or had better paths. */
import { layerEnds } from '../state'
import { CopiedRace } from './copied_race'
import type { RaceLink } from './link_of_race'
import { type Made, type Making, titleOfRace } from './make_film'
import type { FilmLook } from './settings'
import { evenly, thinned } from './step_moments'
import { Sheet, stepName } from './steps_svg'

export const STEPS = { least: 4, most: 24 }

export interface StepSettings extends FilmLook {
  /** The last iteration. */
  last: number
  steps: number
  spread: 'even' | 'better'
  /** One picture that moves, or one file for each step. */
  as: 'steps' | 'slides'
}

/** Null where it was given up. */
export async function makeSteps(
  settings: StepSettings,
  link: RaceLink,
  stem: string,
  { signal, onFrame }: Making,
): Promise<Made | null> {
  const moments = await momentsOf(settings, signal)
  const race = signal.aborted ? null : await CopiedRace.of(settings.panels)
  if (!race) return null
  signal.addEventListener('abort', () => race.end())
  try {
    const sheet = await Sheet.of(race.map, settings, link)
    const steps: SVGElement[] = []
    for (const at of moments) {
      await race.goTo({ at, last: at === settings.last }, 'iteration')
      const look = { layer: settings.layer, ends: layerEnds.peek(), theme: settings.theme }
      steps.push(await sheet.step(race.runs(), await race.seen(look)))
      onFrame?.(steps.length, moments.length)
    }
    if (signal.aborted) return null
    const file = settings.as === 'steps' ? moving(sheet, steps) : await archive(sheet, steps, stem)
    const ending = settings.as === 'steps' ? 'svg' : 'zip'
    return { file, ending, agreement: race.agreement }
  } catch (error) {
    if (signal.aborted) return null
    throw error
  } finally {
    race.end()
  }
}

/** Iterations, in order. */
async function momentsOf(settings: StepSettings, signal: AbortSignal): Promise<number[]> {
  const { last, steps, spread } = settings
  if (spread === 'even') return evenly(last, steps)
  const scout = await CopiedRace.of(settings.panels)
  signal.addEventListener('abort', () => scout?.end())
  try {
    await scout?.goTo({ at: last, last: true }, 'iteration')
    return thinned(
      [...(scout?.improved ?? [])].filter((at) => at < last),
      last,
      steps,
    )
  } catch (error) {
    if (signal.aborted) return []
    throw error
  } finally {
    scout?.end()
  }
}

const moving = (sheet: Sheet, steps: SVGElement[]) =>
  new Blob([sheet.file(steps, titleOfRace())], { type: 'image/svg+xml' })

/** The same whenever it is made: no clock is asked. */
const FILE_DATE = new Date(2000, 0, 1)

async function archive(sheet: Sheet, steps: SVGElement[], stem: string): Promise<Blob> {
  const { downloadZip } = await import('client-zip')
  const files = steps.map((step, i) => ({
    name: `${stem}-${String(i + 1).padStart(2, '0')}.svg`,
    input: sheet.file([step], stepName(i + 1, steps.length)),
    lastModified: FILE_DATE,
  }))
  return downloadZip(files).blob()
}
