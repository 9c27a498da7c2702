/** Opens what a page of one file carries (docs/formats.md). Imported by that page alone. */
import { effect } from '@preact/signals'
import { language } from '../i18n'
import { oneFile } from '../model/one_file'
import { textOf } from '../share/page_file'
import { importText } from './files'
import { view } from './page_view'
import { autoplay, openFirstSession } from './sessions'
import { openBefore } from './start_page'

openBefore(openCarried)

/** A link in the address goes before it. False where there is nothing that could be opened, and the reader knows. */
async function openCarried(): Promise<boolean> {
  const carried = oneFile()?.carried ?? ''
  if (carried === '' || /^#[xq]=/.test(location.hash)) return false
  keepTitle()
  const text = textOf(carried)
  if (!isComparison(text)) return importText(text)
  // Behind it there is a race too.
  openFirstSession()
  await importText(text)
  autoplay()
  return true
}

function isComparison(text: string): boolean {
  if (text.startsWith('#')) return text.startsWith('#q')
  try {
    return 'question' in JSON.parse(text)
  } catch {
    // What is wrong with it is said when it is opened.
    return false
  }
}

/** The tab is called as the file is, while the race that it carries is on show. */
function keepTitle(): void {
  const title = oneFile()?.title ?? ''
  effect(() => {
    language.value
    if (view.value === 'race') document.title = title
  })
}
