/** Files dropped on the page. */
import type { Page } from '@playwright/test'

/** A file's name and what it holds. */
export type Dropped = [name: string, content: string | Buffer]

/** Drops files together on the element of a selector. */
export async function dropFiles(page: Page, on: string, files: Dropped[]): Promise<void> {
  const plain = files.map(([name, content]) => [name, Buffer.from(content).toString('base64')])
  const transfer = await page.evaluateHandle((all) => {
    const data = new DataTransfer()
    for (const [name = '', base64 = ''] of all) {
      const bytes = Uint8Array.from(atob(base64), (char) => char.charCodeAt(0))
      data.items.add(new File([bytes], name))
    }
    return data
  }, plain)
  await page.dispatchEvent(on, 'drop', { dataTransfer: transfer })
}
