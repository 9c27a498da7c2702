/** The open comparison as a link, with what came out of its runs as far as there is room. */
import type { Analysis, EntryAnalysis } from '../../model/analysis'
import { encodeDocument, PREFIX } from '../../share/comparison_link'
import { LINK_LIMIT } from '../../share/envelope'
import { pageAddress } from '../../share/page_file'
import type { NumbersOfLink, RecordedNumbers } from '../../share/recorded_numbers'
import { analysisNow, openComparison, progress, resultFile } from '../run/actions'

/** The text after `#q=`. */
export async function linkOfNow(): Promise<{ text: string; carriesNumbers: boolean }> {
  const [document, numbers] = await Promise.all([resultFile('link'), numbersNow()])
  const room = LINK_LIMIT - pageAddress().length - PREFIX.length
  const whole = numbers && (await encodeDocument(document, numbers))
  if (whole !== null && whole.length <= room) return { text: whole, carriesNumbers: true }
  return { text: await encodeDocument(document), carriesNumbers: false }
}

/** The whole fragment; null where no comparison is open. */
export async function fragmentOfNow(): Promise<string | null> {
  return openComparison.peek() && `${PREFIX}${(await linkOfNow()).text}`
}

/** Of the runs that are done here, else as they came with a link: who hands it on has not changed them. */
async function numbersNow(): Promise<NumbersOfLink | null> {
  const now = openComparison.peek()
  if (progress.peek().done === 0) return now?.numbers ?? null
  const analysis = await analysisNow()
  return analysis && numbersOf(analysis)
}

const numbersOf = ({ instances }: Analysis): NumbersOfLink =>
  instances.map(({ entries }) => entries.map(ofEntry))

/** Runs from elsewhere travel with the question, so their numbers need not. */
function ofEntry({ origin, runs, with_path, summary, gap }: EntryAnalysis): RecordedNumbers | null {
  if (origin !== 'planner' || runs === 0) return null
  const { least: best = null, median = null } = summary ?? {}
  return { runs, withPath: with_path, best, median, gap: gap?.median ?? null }
}
