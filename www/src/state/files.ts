/** Files and texts in: what opens them is fetched when it is first needed, as most visits only watch. */
import { lazyParts } from './lazy_parts'
import { notifyError } from './notices'

const opener = () => lazyParts.opener()

export interface Opening {
  /** Opens what leaves a choice as it is usually meant, instead of asking. */
  unasked?: boolean
}

/** A share link, or the contents of any file we read; refusals are thrown, and leave the page as it was. */
export const openText = async (text: string, opening?: Opening) =>
  (await opener()).openText(text, opening)
/** Files that came together: some belong to each other. */
export const openFiles = async (files: Iterable<File>) => (await opener()).openFiles([...files])

/** Like the functions above, but shows refusals as messages. True when all was opened. */
export const importText = (text: string, opening?: Opening) => shown(openText(text, opening))
export const importFiles = (files: Iterable<File>) => shown(openFiles(files))
/** What was dropped, folders too. The transfer tells of its files only while the event lasts. */
export const importDropped = (transfer: DataTransfer) => {
  const files = [...transfer.files]
  const entries = [...transfer.items].flatMap((item) => item.webkitGetAsEntry?.() ?? [])
  return shown(opener().then(({ openDropped }) => openDropped(files, entries)))
}

async function shown(opening: Promise<boolean>): Promise<boolean> {
  try {
    return await opening
  } catch (error) {
    notifyError(error)
    return false
  }
}
