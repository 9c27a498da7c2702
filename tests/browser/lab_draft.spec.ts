import { expect, type Page, test } from '@playwright/test'
import type { ComparisonDocument } from '../../www/src/model/comparison'
import { ComparisonPage, inStorage } from './comparison_page'

interface Draft {
  changed: number
  title: string | null
  entries: { planner: string }[]
  seeds: { from: number; count: number }
  files: { name: string }[]
}

/** What the browser has kept so far, newest first. */
async function drafts(page: Page): Promise<Draft[]> {
  const all = await inStorage<Draft[]>(page, 'drafts', 'getAll')
  return all.sort((a, b) => b.changed - a.changed)
}

test.describe('a comparison that is being put together', () => {
  test('is there again after the page has been loaded anew', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.on('two-corridors', 'aco-20x20')
    await comparison.compare('ant-system', 'astar')
    await comparison.set(1, 'ants', 9)
    await comparison.seeds(7, 3)
    await page.getByTestId('study-title').fill('Nine ants')
    await page.getByTestId('own-file').setInputFiles({
      name: 'mine.csv',
      mimeType: 'text/csv',
      buffer: Buffer.from('algorithm,map,seed,length\nmine,two-corridors,3,20\n'),
    })
    await expect(page.getByTestId('own-file-item')).toHaveCount(1)
    await expect
      .poll(() => drafts(page))
      .toMatchObject([
        { title: 'Nine ants', seeds: { from: 3, count: 7 }, files: [{ name: 'mine.csv' }] },
      ])

    await page.reload()
    await comparison.ready()
    await expect(comparison.entries).toHaveCount(2)
    await expect(comparison.maps).toHaveCount(2)
    await expect(page.getByTestId('study-title')).toHaveValue('Nine ants')
    await expect(page.getByTestId('own-file-item')).toHaveCount(1)
    await comparison.run()
    await comparison.finished()
    const text = await page.evaluate(() => window.formicarium.resultFile('link'))
    const { title, seeds, instances, entries } = (JSON.parse(text) as ComparisonDocument).question
    expect([title, seeds]).toEqual(['Nine ants', { from: 3, count: 7 }])
    expect(instances.map(({ id }) => id)).toEqual(['two-corridors', 'classic-20-20'])
    expect(entries).toMatchObject([
      { planner: 'ant-system', set: { ants: 9 } },
      { planner: 'astar' },
      { label: 'mine' },
    ])
  })

  test('is there again however soon after a change it is left', async ({ page }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.compare('ant-system', 'astar')
    await expect.poll(() => drafts(page)).toMatchObject([{ seeds: { count: 30 } }])
    for (const [leave, count] of [
      ['page', '7'],
      ['view', '9'],
    ] as const) {
      // All in one turn of the page: no timer comes between.
      await page.evaluate(
        ([leave, count]) => {
          const find = <T extends HTMLElement>(id: string) =>
            document.querySelector<T>(`[data-testid="${id}"]`)
          const field = find<HTMLInputElement>('seed-count')
          if (!field) throw new Error('there is no field for seeds')
          field.value = count
          for (const kind of ['input', 'change'])
            field.dispatchEvent(new Event(kind, { bubbles: true }))
          if (leave === 'view') find('view-race')?.click()
          location.reload()
        },
        [leave, count] as const,
      )
      await page.waitForLoadState()
      if (leave === 'view') await page.getByTestId('view-lab').click()
      await comparison.ready()
      await expect(page.getByTestId('seed-count')).toHaveValue(count)
      await expect(comparison.entries).toHaveCount(2)
    }
  })

  test('keeps planners that the page does not know until the whole engine is there', async ({
    page,
  }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.compare('ship', 'max-min-ant-system')
    const planners = async () => (await drafts(page))[0]?.entries.map(({ planner }) => planner)
    await expect.poll(planners).toEqual(['ship', 'max-min-ant-system'])
    await page.reload()
    await comparison.ready()
    await expect(comparison.entries).toHaveCount(2)
    await expect(comparison.entry(1).getByTestId('entry-label')).toHaveAttribute(
      'placeholder',
      'Engine-room ACO',
    )
    await expect.poll(planners).toEqual(['ship', 'max-min-ant-system'])
  })

  test('belongs to its tab: another one begins with what races', async ({ page, context }) => {
    const comparison = new ComparisonPage(page)
    await comparison.open()
    await comparison.compare('ship')
    await comparison.seeds(7)
    await expect
      .poll(() => drafts(page))
      .toMatchObject([{ entries: [{ planner: 'ship' }], seeds: { count: 7 } }])
    const other = new ComparisonPage(await context.newPage())
    await other.openFromRace()
    await expect(other.entries).toHaveCount(2)
    await expect(other.page.getByTestId('seed-count')).toHaveValue('30')
  })
})
