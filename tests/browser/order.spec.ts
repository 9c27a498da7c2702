/** Instances of TSPLIB: their places in an order, proven and by ants, beside a map that stays. */
import { expect, type Page, test } from '@playwright/test'
import { expectClean } from './axe'
import { answered, commandLine } from './command_line'
import { RacePage } from './race_page'
import { zipOf } from './zips'

const PLACES = [
  [16.47, 96.1],
  [16.47, 94.44],
  [20.09, 92.54],
  [22.39, 93.37],
  [25.23, 97.24],
  [22.0, 96.05],
  [20.47, 97.02],
  [17.2, 96.29],
  [16.3, 97.38],
  [14.05, 98.12],
  [16.53, 97.38],
  [21.52, 95.59],
  [19.41, 97.13],
  [20.09, 94.55],
]
const HEAD =
  'NAME: burma14\nTYPE: TSP\nCOMMENT: 14-Staedte in Burma (Zaw Win)\nDIMENSION: 14\nEDGE_WEIGHT_TYPE: GEO\nNODE_COORD_SECTION\n'
const BURMA14 = `${HEAD}${PLACES.map((at, i) => [i + 1, ...at].join(' ')).join('\n')}\nEOF\n`
const TOUR = `TYPE: TOUR\nDIMENSION: 14\nTOUR_SECTION\n${PLACES.map((_, i) => i + 1).join('\n')}\n-1\nEOF\n`
const MATRIX =
  'NAME: four\nTYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: UPPER_ROW\nEDGE_WEIGHT_SECTION\n1 2 3 4 5 6\nEOF\n'

/** More places than dynamic programming proves, with whole coordinates from a simple generator. */
const SCATTERED = `NAME: scattered\nTYPE: TSP\nDIMENSION: 24\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n${Array.from(
  { length: 24 },
  (_, i) => `${i + 1} ${(i * 7919 + 13) % 101} ${(i * 104_729 + 57) % 97}`,
).join('\n')}\nEOF\n`

const dialog = (page: Page) => page.getByTestId('order-dialog')
const said = (page: Page, row: string) => page.getByTestId(`order-${row}`)

async function opened(race: RacePage, ...files: [string, string][]): Promise<void> {
  await race.dropTogether(
    files.map(([name, text]) => [name, Buffer.from(text)] as [string, Buffer]),
  )
  await expect(dialog(race.page)).toBeVisible()
}

async function rested(page: Page): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  return race
}

/** Runs to the end, and gives what is saved of it, once it holds what is `awaited`. */
async function ran(page: Page, awaited?: string) {
  await page.getByTestId('order-run').click()
  await expect(said(page, 'iteration')).toHaveText('200 of 200')
  let run = await saved(page)
  await expect(async () => {
    if (awaited !== undefined && !(awaited in run)) run = await saved(page)
    expect(awaited === undefined || awaited in run).toBe(true)
  }).toPass()
  return run
}

async function saved(page: Page) {
  const saving = page.waitForEvent('download')
  await page.getByTestId('order-json').click()
  const stream = await (await saving).createReadStream()
  const chunks: Buffer[] = []
  for await (const chunk of stream) chunks.push(chunk as Buffer)
  return JSON.parse(Buffer.concat(chunks).toString())
}

test.describe('an instance of TSPLIB', () => {
  test('is proven, run and saved, and leaves the map alone', async ({ page }) => {
    const race = await rested(page)
    const before = (await race.session()).scenario
    await opened(race, ['burma14.tsp', BURMA14], ['burma14.opt.tour', TOUR])
    await expect(dialog(page)).toContainText('Order of 14 places')
    await expect(said(page, 'exact')).toHaveText('3323, proven')
    await expect(said(page, 'listed')).toContainText('3323')
    await expect(dialog(page)).toContainText('Tour in burma14.opt.tour')
    await expectClean(page, 'an order problem')

    const first = await ran(page)
    const [run] = first.runs
    expect(first.exact.cost).toBe(3323)
    expect(run.cost).toBeLessThan(1.2 * 3323)
    expect([...run.places].sort((a: number, b: number) => a - b)).toEqual(
      PLACES.map((_, i) => i + 1),
    )
    await expect(said(page, 'gap')).toHaveText(`${(100 * run.gap).toFixed(2)} %`)
    await page.getByTestId('order-restart').click()
    await expect(said(page, 'iteration')).toHaveText('0 of 200')
    expect(await ran(page)).toEqual(first)

    await page.keyboard.press('Escape')
    await expect(dialog(page)).toBeHidden()
    expect((await race.session()).scenario).toEqual(before)
  })

  test('without coordinates is drawn on a circle; steps, trails and settings', async ({ page }) => {
    const race = await rested(page)
    await race.dropTogether([['both.zip', zipOf([['four.tsp', MATRIX]])]])
    await expect(dialog(page)).toContainText('drawn on a circle')
    await page.getByTestId('order-step').click()
    await expect(said(page, 'iteration')).toHaveText('1 of 200')
    await page.getByTestId('order-trails').check()
    await page.getByTestId('order-step').click()
    await expect(said(page, 'iteration')).toHaveText('2 of 200')
    await page.getByTestId('order-open').click()
    // From 1 by 2 and 3 to 4: 1 + 4 + 6.
    await expect(said(page, 'exact')).toHaveText('11, proven')
    await page.getByTestId('order-ants').fill('0')
    await page.getByTestId('order-ants').press('Tab')
    await expect(dialog(page).getByRole('alert')).toContainText('1 to 1024')
    await page.getByTestId('order-ants').fill('9')
    await page.getByTestId('order-ants').press('Tab')
    await expect(dialog(page).getByRole('alert')).toHaveCount(0)
  })

  test('shows its places at once, and a tour that joins it; one that does not fit is named', async ({
    page,
  }) => {
    const race = await rested(page)
    await opened(race, ['burma14.tsp', BURMA14])
    const drawn = () =>
      page.getByTestId('order-picture').evaluate((canvas: HTMLCanvasElement) => {
        const context = canvas.getContext('2d')
        const pixels = context?.getImageData(0, 0, canvas.width, canvas.height).data ?? []
        return pixels.filter((value, at) => at % 4 === 3 && value > 0).length
      })
    await expect.poll(drawn).toBeGreaterThan(100)
    const places = await drawn()
    await page.getByTestId('order-shown').selectOption('exact')
    await expect.poll(drawn).toBeGreaterThan(2 * places)

    await page.getByTestId('order-shown').selectOption('ants')
    await race.drop('short.tour', TOUR.replace('\n7\n', '\n'))
    await expect(page.getByTestId('toast-error')).toContainText('short.tour')
    await expect(dialog(page)).toBeVisible()
    await race.drop('good.tour', TOUR)
    await expect(dialog(page)).toContainText('Tour in good.tour')
    await expect(page.getByTestId('order-shown')).toHaveValue('tour')
    await expect.poll(drawn).toBeGreaterThan(2 * places)
    await race.drop('small.txt', '0 0 1\n0 0 0\n1 0 0\n')
    await expect(page.getByTestId('dialog-notice')).toContainText('small.txt was not opened')
    await expectClean(page, 'an order problem with a notice')
    await expect(dialog(page)).toBeVisible()
  })

  test('of more places is searched after the run, as the command line does', async ({ page }) => {
    const cli = commandLine()
    await opened(await rested(page), ['scattered.tsp', SCATTERED])
    await expect(said(page, 'exact')).toContainText('unknown')
    await expect(said(page, 'bound')).toHaveText('–')
    const run = await ran(page, 'bound')
    await expect(said(page, 'exact')).toHaveText(`${run.bound.cost}, proven`)
    await expect(said(page, 'search')).toHaveText(`${run.bound.cost}`)
    await expect(said(page, 'bound')).toContainText(/1-trees?$/)
    await page.getByTestId('order-shown').selectOption('search')
    await expectClean(page, 'an order problem that was searched')
    const told = answered<typeof run>(cli, { 'scattered.tsp': SCATTERED }, [
      'order',
      'scattered.tsp',
    ])
    expect(told.bound.complete).toBe(true)
    expect(run).toMatchObject({ bound: told.bound, runs: told.runs })
    await page.getByTestId('order-restart').click()
    await expect(said(page, 'bound')).toHaveText('–')
    await expect(said(page, 'exact')).toContainText('unknown')
  })

  test('of vehicles is refused by name', async ({ page }) => {
    const race = await rested(page)
    const before = (await race.session()).scenario
    await race.drop('goods.vrp', BURMA14.replace('TYPE: TSP', 'TYPE: CVRP'))
    await expect(page.getByText(/vehicle routing problem/i).first()).toBeVisible()
    await expect(dialog(page)).toBeHidden()
    expect((await race.session()).scenario).toEqual(before)
  })
})
