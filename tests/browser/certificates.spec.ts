/** What planners have proven of their results, told beside their numbers as the command line tells it. */
import { execFileSync } from 'node:child_process'
import { expect, type Page, test } from '@playwright/test'
import type { ParamValues } from '../../www/src/model/messages'
import { expectClean } from './axe'
import { answered, commandLine } from './command_line'
import { RacePage } from './race_page'

const PLAIN = { preset: null, label: null, result: null }
/** A proof that may hardly expand anything. */
const CUT_OFF = { proof_limit: 0.001, iterations: 1, widening: 0, corridor: 0 }
const SEED = 3

interface Told {
  value: number
  certificate: { lower_bound: number; expansions: number; complete: boolean }
}

interface Asked {
  planner: string
  params?: ParamValues
}

const rooms = (cli: string) =>
  execFileSync(cli, ['generate', 'rooms', '--size', '64x64', '--seed', '2'], { encoding: 'utf8' })

function planned(cli: string, map: string, { planner, params = {} }: Asked): Told {
  const set = Object.entries(params).flatMap(([key, value]) => ['--set', `${key}=${value}`])
  const args = ['plan', 'rooms.json', '--planner', planner, '--seed', `${SEED}`, ...set]
  return answered<Told>(cli, { 'rooms.json': map }, args)
}

/** These planners on a map, at rest. */
async function open(page: Page, map: string, asked: Asked[]): Promise<RacePage> {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.evaluate((text) => window.formicarium.load(text), map)
  const panels = asked.map(({ planner, params = {} }) => ({ ...PLAIN, planner, params }))
  await race.evaluate(
    async ([panels, seed]) => {
      const session = window.formicarium.session()
      if (session) await window.formicarium.load({ ...session, seed, panels })
    },
    [panels, SEED] as const,
  )
  await race.ready()
  return race
}

async function finish(race: RacePage): Promise<void> {
  await race.press('run-to-end')
  await expect.poll(() => race.attribute('play', 'data-phase')).toBe('finished')
}

const proof = (page: Page, place = 1) => page.getByTestId(`metric-proof-${place}`)

async function bound(page: Page, place = 1): Promise<number> {
  await expect(proof(page, place)).toHaveAttribute('data-value', /\d/)
  return Number(await proof(page, place).getAttribute('data-value'))
}

const expanded = (count: number) => `${count.toLocaleString('en')} expanded`

test('formica and searches tell the command line’s certificates', async ({ page }) => {
  const cli = commandLine()
  const map = rooms(cli)
  for (const pair of [
    [{ planner: 'formica' }, { planner: 'any-angle' }],
    [{ planner: 'astar' }, { planner: 'turn-aware' }],
    [{ planner: 'd-star-lite' }, { planner: 'dijkstra' }],
  ] satisfies Asked[][]) {
    await finish(await open(page, map, pair))
    for (const [index, asked] of pair.entries()) {
      const { certificate } = planned(cli, map, asked)
      expect(certificate.complete).toBe(true)
      expect(await bound(page, index + 1), asked.planner).toBe(certificate.lower_bound)
      await expect(proof(page, index + 1)).toContainText(expanded(certificate.expansions))
      const than = asked.planner === 'turn-aware' ? 'has less' : 'is shorter'
      await expect(proof(page, index + 1)).toContainText(`proven: no path ${than}`)
    }
  }
})

test('a proof that was cut off leaves an interval', async ({ page }) => {
  const cli = commandLine()
  const map = rooms(cli)
  const asked = { planner: 'formica', params: CUT_OFF }
  await finish(await open(page, map, [asked, { planner: 'ant-system' }]))
  const { value, certificate } = planned(cli, map, asked)
  expect(certificate.complete).toBe(false)
  expect(await bound(page)).toBe(certificate.lower_bound)
  const within = Math.ceil((value / certificate.lower_bound - 1) * 1e4) / 100
  await expect(proof(page)).toContainText(`within ${within}%, proven`)
  await expect(proof(page)).toContainText(
    `${certificate.lower_bound.toFixed(2)} – ${value.toFixed(2)}, ${expanded(certificate.expansions)}`,
  )
  await expect(proof(page, 2), 'a colony that proves nothing').toHaveText('–')
  await expectClean(page, 'an interval')
})

test('a search at rest tells what it has proven so far, and the row stays as high', async ({
  page,
}) => {
  const map = rooms(commandLine())
  const race = await open(page, map, [{ planner: 'any-angle' }, { planner: 'turn-aware' }])
  await expect(proof(page)).toHaveText('–')
  const row = page.getByRole('row').filter({ has: proof(page) })
  const height = async () => (await row.boundingBox())?.height
  const before = await height()
  const bounds: number[] = []
  for (let round = 0; round < 2; round++) {
    await race.evaluate(() => window.formicarium.run({ iterations: 3 }), null)
    await expect(proof(page)).toContainText('so far: no path below')
    await expect.poll(() => bound(page)).toBeGreaterThan(bounds.at(-1) ?? 0)
    bounds.push(await bound(page))
    expect(await height()).toBe(before)
  }
  await finish(race)
  await expect(proof(page)).toContainText('proven: no path is shorter')
  expect(await bound(page)).toBeGreaterThan(bounds.at(-1) ?? 0)
  expect(await height()).toBe(before)

  // Looking back, it is what was proven by then.
  await race.evaluate(() => window.formicarium.look(3), null)
  await expect(proof(page)).toContainText('so far: no path below')
  expect(await bound(page)).toBe(bounds[0])
  await race.evaluate(() => window.formicarium.look(null), null)
  await expect(proof(page)).toContainText('proven: no path is shorter')
})

test('where no planner proves anything there is no such row', async ({ page }) => {
  const unproven = { planner: 'formica', params: { ...CUT_OFF, proof_limit: 0 } }
  await finish(await open(page, rooms(commandLine()), [unproven, { planner: 'theta-star' }]))
  await expect(page.getByTestId('metric-length-1')).toBeVisible()
  await expect(proof(page)).toHaveCount(0)
})

test('scent and merged cells are drawn and named', async ({ page }) => {
  const race = await open(page, rooms(commandLine()), [{ planner: 'formica' }])
  const choice = page.getByTestId('layer')
  const legend = page.getByTestId('panel-1').locator('.layer-legend')
  const seen = new Set<string>()
  await race.evaluate(() => window.formicarium.run({ iterations: 1 }), null)
  for (const [layer, en, zh] of [
    ['none', '', ''],
    ['scent', 'Scent', '气味'],
    ['merged', 'Merged', '合并区域'],
  ] as const) {
    await choice.selectOption(layer)
    seen.add((await race.picture()).toString('base64'))
    if (layer === 'none') continue
    const item = choice.locator(`option[value=${layer}]`)
    await expect(item).toHaveText(en)
    await expect(legend).toContainText(en)
    await race.menu('language', 'language-zh-CN')
    await expect(item).toHaveText(zh)
    await expect(legend).toContainText(zh)
    await race.menu('language', 'language-en')
  }
  expect(seen.size).toBe(3)
})

test('in Chinese', async ({ page }) => {
  const map = rooms(commandLine())
  const asked = [{ planner: 'formica', params: CUT_OFF }, { planner: 'turn-aware' }]
  const race = await open(page, map, asked)
  await race.menu('language', 'language-zh-CN')
  await finish(race)
  await expect(proof(page)).toContainText(/已证明：差距不超过 [\d.]+%.*扩展 [\d,]+ 格/)
  await expect(proof(page, 2)).toContainText('已证明：没有更小的值')
  const head = page
    .getByRole('row')
    .filter({ has: proof(page) })
    .getByRole('rowheader')
  await expect(head).toHaveText('证明')
  await expect(head).toHaveAttribute('title', /下界/)
  await expectClean(page, 'in Chinese')
})

test('on a phone @phone', async ({ page }) => {
  const map = rooms(commandLine())
  await finish(await open(page, map, [{ planner: 'formica' }, { planner: 'any-angle' }]))
  await page.getByTestId('column').tap()
  await expect(proof(page)).toContainText('proven: no path is shorter')
  await proof(page, 2).scrollIntoViewIfNeeded()
  await expect(proof(page, 2)).toBeInViewport()
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
  expect(overflow).toBeLessThanOrEqual(0)
  await expectClean(page, 'the sheet on a phone')
})
