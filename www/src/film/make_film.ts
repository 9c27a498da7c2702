/** Makes a film of the race: a copy of its runs goes from moment to moment, and each becomes a frame of a file. */
import { caption, scenario } from '../state'
import { type Agreement, CopiedRace } from './copied_race'
import { type Encoding, newFilm } from './encode'
import type { RaceLink } from './link_of_race'
import { type FilmSettings, framesOf } from './settings'
import { Studio } from './studio'

export interface Made {
  file: Blob
  ending: string
  agreement: Agreement
}

/** What is told while something is being made, and how it is given up. */
export interface Making {
  signal: AbortSignal
  /** With the canvas as it is, where there is one. */
  onFrame?: (done: number, of: number, canvas?: OffscreenCanvas) => void
}

/** Null where it was given up; nothing is left of it then. */
export async function makeFilm(
  settings: FilmSettings,
  encoding: Encoding,
  link: RaceLink,
  { signal, onFrame }: Making,
): Promise<Made | null> {
  const race = await CopiedRace.of(settings.panels)
  if (!race) return null
  signal.addEventListener('abort', () => race.end())
  try {
    const studio = await Studio.of(race, settings, link)
    const tags = { title: titleOfRace(), comment: commentOf(link) }
    const film = await newFilm(studio.canvas, encoding, settings.rate, tags)
    const frames = framesOf(settings)
    try {
      for (let frame = 0; frame < frames && !signal.aborted; frame++) {
        await studio.draw(frame)
        await film.add(frame)
        onFrame?.(frame + 1, frames, studio.canvas)
      }
    } catch (error) {
      await film.drop()
      throw error
    }
    if (signal.aborted) {
      await film.drop()
      return null
    }
    return { file: await film.finish(), ending: encoding.ending, agreement: race.agreement }
  } catch (error) {
    if (signal.aborted) return null
    throw error
  } finally {
    race.end()
  }
}

export const titleOfRace = () =>
  caption.peek().title.trim() || scenario.peek()?.spec.name || 'Formicarium'

/** For people, and for the page: it opens the race of a film by the link in it (share/film_text.ts). */
const commentOf = ({ link }: RaceLink) =>
  link === null ? '' : `Open in Formicarium to run this race again, bit for bit:\n${link}\n`
