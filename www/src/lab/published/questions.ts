/** The papers' claims as questions that can be run here: those of experiments/*.toml, as on the command line. */
import all from 'virtual:paper-questions'
import { paperMaps } from '../../gallery/paper_maps'
import { type ComparisonDocument, textOf } from '../../model/comparison'
import { poolSize } from '../run/pool'

export interface PaperQuestion {
  /** The name of its file. */
  id: string
  /** In English, as it is written there. */
  title: string
  paper: string
  /** Seeds of the committed question. */
  seeds: number
  /** Its maps: files below experiments/maps, without their ending. */
  maps: string[]
  entries: number
  /** Runs with one seed. */
  runs: number
  /** Ant moves of these runs. */
  moves: number
  /** Whether all of its maps are terrains. */
  onTerrain: boolean
  /** The paper's card in docs/papers, without its ending; null where it has none. */
  card: string | null
  document(): Promise<string>
}

export const questions: PaperQuestion[] = all

/** Of one worker, on a virtual machine of our days: ants on terrains reckon more at each move. */
const MOVES_PER_SECOND = { plane: 12e6, terrain: 2.3e6 }
/** To hand a run out and take it in. */
const SECONDS_PER_RUN = 0.004

/** A rough estimate of how long this many seeds take on this machine. */
export function secondsFor({ moves, runs, onTerrain }: PaperQuestion, seeds: number): number {
  const each = moves / MOVES_PER_SECOND[onTerrain ? 'terrain' : 'plane'] + runs * SECONDS_PER_RUN
  return (seeds * each) / poolSize(runs * seeds)
}

/** The question that belongs to a map of the gallery, if that map stands for a paper's. */
export function questionOfMap(galleryId: string | null): PaperQuestion | null {
  const file = paperMaps.find(({ id }) => id === galleryId)?.file
  if (file === undefined) return null
  return questions.find(({ paper, maps }) => paper !== '' && maps.includes(file)) ?? null
}

/** The question with its maps, for the first `seeds` of its seeds. */
export async function documentFor(question: PaperQuestion, seeds: number): Promise<string> {
  const document = JSON.parse(await question.document()) as ComparisonDocument
  document.question.seeds.count = Math.min(seeds, question.seeds)
  return textOf(document)
}
