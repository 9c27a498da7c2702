/** The open comparison as links for the shares of a class. */
import { documentOf, textOf } from '../../model/comparison'
import { encodeDocument, PREFIX } from '../../share/comparison_link'
import { pageAddress } from '../../share/page_file'
import { shareEnding } from '../../share/share_of_class'
import { openComparison } from '../run/actions'

/** The text after `#q=`: question and maps alone, so that nobody's results are shown to those who are to compute them. */
export function textOfQuestion(): Promise<string> {
  const { recorded: _, rows: __, ...question } = documentOf(openComparison.peek()?.document ?? '{}')
  return encodeDocument(textOf(question))
}

/** The address of a share; of the one link for all, where `index` is null. */
export const linkOfShare = (link: string, index: number | null, of: number) =>
  link + shareEnding({ index, of })

/** The address of the open comparison, to which the share is added. */
export const linkOfQuestion = async () => `${pageAddress()}${PREFIX}${await textOfQuestion()}`
