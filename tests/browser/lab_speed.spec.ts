import { cpus, loadavg } from 'node:os'
import { expect, test } from '@playwright/test'
import { ComparisonPage } from './comparison_page'

const SIX = [
  'ant-system',
  'elitist-ant-system',
  'rank-based-ant-system',
  'max-min-ant-system',
  'ant-colony-system',
  'ship',
]

/** Numbers to read, not to pass: they depend on the machine and on what else it does. */
const machine = () => `${cpus().length} processors, load ${loadavg()[0]?.toFixed(1)}`

test('six planners with 30 seeds on a 20 × 20 map', async ({ page }) => {
  test.slow()
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.on('aco-20x20')
  await comparison.compare(...SIX)
  await comparison.seeds(30)
  const began = performance.now()
  await comparison.run()
  await comparison.finished(120_000)
  const seconds = (performance.now() - began) / 1000
  console.log(`180 runs of six planners: ${seconds.toFixed(1)} s (${machine()})`)
  expect(await comparison.done()).toBe(180)
})

test('100 seeds of one planner on one worker and on all', async ({ page }) => {
  test.slow()
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.on('aco-20x20')
  await comparison.compare('ant-system')
  await comparison.set(1, 'iterations', 1600)
  await comparison.seeds(100)
  await comparison.run()
  await comparison.finished(120_000)
  const document = await page.evaluate(() => window.formicarium.resultFile('json'))
  const { rows: _, recorded: __, ...asked } = JSON.parse(document)
  const seconds = async (workers?: number) => {
    const options = { document: JSON.stringify(asked), ...(workers && { workers }) }
    const result = await comparison.script(options)
    expect([result.runs, result.failed]).toEqual([100, 0])
    return result.seconds
  }
  const [one, all] = [await seconds(1), await seconds()]
  const words = `${one.toFixed(1)} s on one worker, ${all.toFixed(1)} s on all`
  console.log(`100 runs: ${words}, ${(one / all).toFixed(2)} times as fast (${machine()})`)
})
