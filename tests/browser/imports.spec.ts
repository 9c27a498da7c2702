/** Files that leave a choice are looked at first: pictures, robots' maps, texts with several matrices, archives and folders. */
import { existsSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { gzipSync } from 'node:zlib'
import { expect, type Page, test } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import { expectClean } from './axe'
import { freshRace, RacePage } from './race_page'
import { ASC } from './rasters'
import { zipOf } from './zips'

const folder = join(process.env.FORMICARIUM_DATA ?? '', 'rosmap')

function robots(name: string): Buffer {
  const path = join(folder, name)
  test.skip(!existsSync(path), `needs rosmap/${name}: set FORMICARIUM_DATA to the folder above it`)
  return readFileSync(path)
}

/** A small robot's map: a wall with a gap, an unknown corner. */
const YAML =
  'image: small.pgm\nresolution: 0.5\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n'
const GRAYS = [
  [254, 254, 254, 254, 254, 205],
  [254, 0, 0, 0, 0, 254],
  [254, 254, 254, 254, 0, 254],
  [254, 254, 254, 254, 254, 254],
]
const PGM = Buffer.concat([Buffer.from('P5\n6 4\n255\n'), Buffer.from(GRAYS.flat())])
const WORLD = { x: -1, y: 2, yaw: 0, frame: '' }

const PROGRAM = [
  'import numpy as np',
  'small = np.array([[0, 0, 1], [0, 0, 0], [1, 0, 0]])',
  'large = np.array([',
  '  [0, 0, 0, 0, 0],',
  '  [0, 1, 1, 1, 0],',
  '  [0, 1, 0, 0, 0],',
  '  [0, 0, 0, 1, 0]])',
  '',
].join('\n')

const dialog = (page: Page) => page.getByTestId('map-dialog')
const open = async (page: Page) => {
  await page.getByTestId('map-open').click()
  await expect(dialog(page)).toBeHidden()
}
const size = async (race: RacePage) => {
  const { width, height } = (await race.session()).scenario.spec
  return [width, height]
}

/** Brings the former map back, cell by cell. */
async function undone(race: RacePage, act: () => Promise<void>): Promise<void> {
  const before = (await race.session()).scenario
  await act()
  expect((await race.session()).scenario.cells).not.toEqual(before.cells)
  await race.page.locator('body').press('Control+z')
  await expect.poll(async () => (await race.session()).scenario.spec).toEqual(before.spec)
  expect((await race.session()).scenario.cells).toEqual(before.cells)
}

async function hover(race: RacePage, cell: Cell): Promise<void> {
  const { x, y } = await race.pointOf(cell)
  await race.page.mouse.move(x, y)
}

/** A floor plan: light floor, a dark wall with a door, and a carpet of middle gray. */
async function floorPlan(page: Page): Promise<Buffer> {
  const base64 = await page.evaluate(() => {
    const canvas = document.createElement('canvas')
    canvas.width = 60
    canvas.height = 40
    const context = canvas.getContext('2d')
    if (!context) throw new Error('no canvas')
    const fill = (colour: string, ...box: [number, number, number, number]) => {
      context.fillStyle = colour
      context.fillRect(...box)
    }
    fill('rgb(240, 240, 240)', 0, 0, 60, 40)
    fill('rgb(20, 20, 20)', 28, 0, 4, 30)
    fill('rgb(150, 150, 150)', 5, 5, 10, 10)
    return canvas.toDataURL('image/png').split(',')[1] ?? ''
  })
  return Buffer.from(base64, 'base64')
}

/** From now on what is called slow.txt is not read before it is released. */
async function stallReads(page: Page): Promise<void> {
  await page.evaluate(() => {
    const read = File.prototype.arrayBuffer
    File.prototype.arrayBuffer = async function () {
      if (this.name === 'slow.txt')
        await new Promise((resolve) => addEventListener('release', resolve, { once: true }))
      return read.call(this)
    }
  })
}

/** Lets go of it, and of whatever comes of it. */
async function release(page: Page): Promise<void> {
  await page.evaluate(async () => {
    dispatchEvent(new Event('release'))
    await new Promise((resolve) => setTimeout(resolve, 300))
  })
}

test.describe('a robot’s map', () => {
  test.beforeEach(async ({ page }) => new RacePage(page).openAtRest())

  test('is cropped to what it knows, and stays where it is in the world', async ({ page }) => {
    const race = new RacePage(page)
    await race.dropTogether([
      ['turtlebot3_map.yaml', robots('turtlebot3_map.yaml')],
      ['turtlebot3_map.pgm', robots('turtlebot3_map.pgm')],
    ])
    await expect(page.getByTestId('map-size')).toContainText('384 × 384')
    const free = await page.getByTestId('map-free').innerText()
    await page.getByTestId('map-extent-known').click()
    await expect(page.getByTestId('map-size')).not.toContainText('384')
    // All that was free still is.
    const count = (text: string) => text.split('·')[0]
    expect(count(await page.getByTestId('map-free').innerText())).toBe(count(free))
    await expectClean(page, 'the dialog of a robot’s map')
    await open(page)
    const [width = 0, height = 0] = await size(race)
    expect(Math.max(width, height)).toBeLessThan(150)
    const { world, start } = (await race.session()).scenario.spec
    expect(world?.x).toBeGreaterThan(-5)
    expect(await race.isWall(start)).toBe(false)
  })

  test('description and picture are one map, with its place in the world', async ({ page }) => {
    const race = new RacePage(page)
    await undone(race, async () => {
      await race.dropTogether([
        ['Small.PGM', PGM],
        ['small.yaml', YAML],
      ])
      await expect(page.getByTestId('map-size')).toContainText('6 × 4')
      await expect(page.getByTestId('map-size')).toContainText('3 × 2 m')
      await expect(page.getByTestId('map-kind')).toContainText('ROS map')
      await expect(page.getByTestId('map-blocked')).toContainText('6')
      await page.getByTestId('map-unknown-free').click()
      await expect(page.getByTestId('map-blocked')).toHaveText(/^5/)
      await expect(page.getByTestId('map-notices')).toContainText('unknown ones count as free')
      await open(page)
      expect(await size(race)).toEqual([6, 4])
      expect(await race.walls()).toBe(5)
    })
    await page.locator('body').press('Control+y')
    await expect.poll(() => size(race)).toEqual([6, 4])
    expect((await race.session()).scenario.spec.world).toEqual(WORLD)
    await hover(race, [1, 3])
    await expect(page.getByTestId('cell-readout').first()).toHaveText('1, 3 x -0.25, y 2.25 m')
    await race.ready()
    await page.locator('body').press('End')
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    const [, search] = await race.results()
    expect(search?.world).toHaveLength(search?.path?.length ?? 0)
  })

  test('its place goes on in links, sessions, a smaller map, and back to ROS', async ({
    page,
    browser,
  }) => {
    const race = new RacePage(page)
    await race.dropTogether([
      ['small.yaml', YAML],
      ['small.pgm', PGM],
    ])
    await expect(dialog(page)).toBeVisible()
    await open(page)
    const { scenario } = await race.session()

    const other = await freshRace(browser, await race.shareLink())
    expect((await other.session()).scenario.spec).toEqual(scenario.spec)
    await other.page.context().close()

    const file = await race.exported('experiment')
    expect(JSON.parse(file.bytes.toString()).scenario.world).toEqual(WORLD)

    await race.menu('map-menu', 'open-export')
    await page.getByTestId('export-ros').click()
    await expect(page.getByTestId('export-preview')).toHaveValue(/image: "small\.pgm"/)
    const saved: [string, Buffer][] = []
    page.on('download', async (one) => {
      const chunks: Buffer[] = []
      for await (const chunk of await one.createReadStream()) chunks.push(Buffer.from(chunk))
      saved.push([one.suggestedFilename(), Buffer.concat(chunks)])
    })
    await page.getByTestId('export-download').click()
    await expect.poll(() => saved.map(([name]) => name).sort()).toEqual(['small.pgm', 'small.yaml'])
    await race.leaveDialog()

    await race.menu('map-menu', 'open-resize')
    await page.getByTestId('resize-height').fill('3')
    await race.applyRules()
    await expect.poll(() => size(race)).toEqual([6, 3])
    expect((await race.session()).scenario.spec.world).toEqual({ ...WORLD, y: 2.5 })

    await race.dropTogether(saved)
    await expect(dialog(page)).toBeVisible()
    await open(page)
    expect((await race.session()).scenario.cells).toEqual(scenario.cells)
    expect((await race.session()).scenario.spec.world).toEqual(WORLD)
  })

  test('a description alone names its picture, asks for it and goes on', async ({ page }) => {
    const race = new RacePage(page)
    await race.importByButton('small.yaml', YAML)
    await expect(page.getByTestId('map-needs')).toContainText('small.pgm')
    await expectClean(page, 'the missing picture')
    await undone(race, async () => {
      await page
        .getByTestId('map-picture')
        .setInputFiles({ name: 'small.pgm', mimeType: 'image/x', buffer: PGM })
      await expect(page.getByTestId('map-size')).toContainText('6 × 4')
      await open(page)
    })
    // Or it is dropped onto the page that waits for it.
    await race.drop('small.yaml', YAML)
    await expect(page.getByTestId('map-needs')).toBeVisible()
    await race.drop('SMALL.pgm', PGM)
    await expect(page.getByTestId('map-kind')).toContainText('ROS map')
    await page.getByTestId('map-cancel').click()
    await expect(dialog(page)).toBeHidden()
  })

  test('a picture of another name is taken with a warning; all else waits', async ({ page }) => {
    const race = new RacePage(page)
    await race.drop('small.yaml', YAML)
    await expect(page.getByTestId('map-needs')).toBeVisible()
    await race.drop('small.txt', '0 0 1\n0 0 0\n1 0 0\n')
    await expect(page.getByTestId('dialog-notice')).toHaveText(
      'First answer the open dialog: small.txt was not opened',
    )
    await expect(page.getByTestId('map-needs')).toBeVisible()
    await race.drop('other.pgm', PGM)
    const warning = page.getByTestId('map-other-picture')
    await expect(warning).toHaveText('This is other.pgm; the description names small.pgm')
    await expect(page.getByTestId('map-kind')).toContainText('ROS map')
    await race.paste('0 0 1\n0 0 0\n1 0 0\n')
    await expect(page.getByTestId('dialog-notice')).toContainText('Pasted map was not opened')
    await expect(dialog(page)).toBeVisible()
    await expectClean(page, 'a picture of another name')
    await open(page)
    expect(await size(race)).toEqual([6, 4])
  })

  test('the real map of a depot opens as it is, and says what its grays mean', async ({ page }) => {
    test.slow()
    const race = new RacePage(page)
    const files: [string, Buffer][] = [
      ['depot.yaml', robots('depot.yaml')],
      ['depot.pgm', robots('depot.pgm')],
    ]
    await undone(race, async () => {
      await race.dropTogether(files)
      await expect(page.getByTestId('map-size')).toContainText('604 × 307')
      await expect(page.getByTestId('map-size')).toContainText('30.2 × 15.35 m')
      await open(page)
      const { world, resolution } = (await race.session()).scenario.spec
      expect([world, resolution]).toEqual([{ x: 0, y: 0, yaw: 0, frame: '' }, 0.05])
      await hover(race, [100, 200])
      await expect(page.getByTestId('cell-readout').first()).toContainText('m')
      const text = (await page.getByTestId('cell-readout').first().textContent()) ?? ''
      const [column = 0, row = 0, x, y] = text.match(/-?[\d.]+/g)?.map(Number) ?? []
      expect(Math.hypot(column - 100, row - 200)).toBeLessThan(3)
      expect(x).toBeCloseTo((column + 0.5) * 0.05, 6)
      expect(y).toBeCloseTo((307 - row - 0.5) * 0.05, 6)
    })
    await race.dropTogether(files)
    await page.getByTestId('map-cells').fill('151')
    await page.getByTestId('map-cells').press('Tab')
    await expect(page.getByTestId('map-size')).toContainText('151 × 77')
    await open(page)
    expect((await race.session()).scenario.spec.resolution).toBeCloseTo(0.2, 9)
    await race.ready()
    await page.locator('body').press('End')
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal', {
      timeout: 60_000,
    })
  })

  test('a real map that is turned has its cells where ROS has them', async ({ page }) => {
    const race = new RacePage(page)
    await race.dropTogether([
      ['testmap.yaml', robots('testmap.yaml')],
      ['testmap.png', robots('testmap.png')],
    ])
    await expect(page.getByTestId('map-size')).toContainText('10 × 10')
    await open(page)
    await hover(race, [3, 2])
    // 0.35 m along, 0.75 m up, turned by 1 rad about (2, 3).
    await expect(page.getByTestId('cell-readout').first()).toHaveText('3, 2 x 1.56, y 3.70 m')
    await race.ready()
    await page.locator('body').press('End')
    await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', /optimal|no-path/)
  })
})

test.describe('a picture', () => {
  test.beforeEach(async ({ page }) => new RacePage(page).openAtRest())

  test('becomes a map by a threshold that is seen as it moves', async ({ page }) => {
    const race = new RacePage(page)
    const plan = await floorPlan(page)
    await undone(race, async () => {
      await race.drop('plan.png', plan)
      await expect(page.getByTestId('map-blocked')).toContainText('120')
      await page.getByTestId('map-threshold').fill('200')
      await expect(page.getByTestId('map-blocked')).toContainText('220')
      await page.getByTestId('map-metres').fill('0.25')
      await page.getByTestId('map-metres').press('Tab')
      await expect(page.getByTestId('map-size')).toContainText('15 × 10 m')
      await open(page)
      expect(await race.walls()).toBe(220)
      expect((await race.session()).scenario.spec.resolution).toBe(0.25)
      await race.ready()
      await page.locator('body').press('End')
      await expect(page.getByTestId('status-2')).toHaveAttribute('data-status', 'optimal')
    })
  })

  test('its other choices: by itself, the light side, a part, fewer cells', async ({ page }) => {
    const race = new RacePage(page)
    await race.drop('plan.png', await floorPlan(page))
    await expect(page.getByTestId('map-size')).toContainText('60 × 40')
    await page.getByTestId('map-threshold-auto').click()
    await expect(page.getByTestId('map-blocked')).toContainText('120')
    await expect(page.getByTestId('map-threshold')).not.toHaveValue('128')
    await page.getByTestId('map-light').click()
    await expect(page.getByTestId('map-free')).toHaveText(/^120/)
    await page.getByTestId('map-dark').click()
    await page.getByTestId('map-crop-width').fill('30')
    await page.getByTestId('map-crop-width').press('Tab')
    await expect(page.getByTestId('map-size')).toContainText('30 × 40')
    await page.getByTestId('map-crop-x').fill('50')
    await page.getByTestId('map-crop-x').press('Tab')
    await expect(dialog(page).getByRole('alert')).toContainText('60 × 40')
    await expect(page.getByTestId('map-open')).toBeDisabled()
    await page.getByTestId('map-crop-whole').click()
    await expect(page.getByTestId('map-size')).toContainText('60 × 40')
    await page.getByTestId('map-cells').fill('15')
    await page.getByTestId('map-cells').press('Tab')
    await expect(page.getByTestId('map-size')).toContainText('15 × 10')
    // What is typed counts before it is committed.
    await page.getByTestId('map-cells').fill('30')
    await expect(page.getByTestId('map-size')).toContainText('30 × 20')
    await expect(page.getByTestId('map-open')).toContainText('30 × 20')
    await page.getByTestId('map-metres').fill('0')
    await expect(page.getByTestId('map-metres-wrong')).toContainText('more than 0')
    await expect(page.getByTestId('map-open')).toBeDisabled()
    await page.getByTestId('map-metres').fill('2')
    await expect(page.getByTestId('map-metres-wrong')).toHaveCount(0)
    await page.getByTestId('map-threshold').fill('0')
    await expect(page.getByTestId('map-blocked')).toHaveText(/^0/)
    await page.getByTestId('map-light').click()
    await expect(dialog(page).getByRole('alert')).toContainText('no free cell')
    await expect(page.getByTestId('map-open')).toBeDisabled()
    const before = await size(race)
    await page.keyboard.press('Escape')
    await expect(dialog(page)).toBeHidden()
    expect(await size(race)).toEqual(before)
  })
})

test.describe('texts, archives, folders', () => {
  test.beforeEach(async ({ page }) => new RacePage(page).openAtRest())

  test('of a program with two matrices the second can be chosen', async ({ page }) => {
    const race = new RacePage(page)
    await undone(race, async () => {
      await race.importByButton('maps.py', PROGRAM)
      const field = page.getByTestId('map-matrix')
      await expect(field.locator('option')).toHaveText([
        '1 · small · 3 × 3 · line 2',
        '2 · large · 5 × 4 · line 4',
      ])
      await expect(page.getByTestId('map-size')).toContainText('3 × 3')
      await field.selectOption('2')
      await expect(page.getByTestId('map-size')).toContainText('5 × 4')
      await open(page)
      expect(await size(race)).toEqual([5, 4])
    })
  })

  test('a map with one meaning is opened at once', async ({ page }) => {
    const race = new RacePage(page)
    await undone(race, async () => {
      await race.drop('small.txt', '0 0 1\n0 0 0\n1 0 0\n')
      await expect.poll(() => size(race)).toEqual([3, 3])
      await expect(page.getByTestId('toast-success')).toContainText('0 was read as free')
    })
  })

  test('what an archive holds is taken as if it had been dropped together', async ({ page }) => {
    const race = new RacePage(page)
    await undone(race, async () => {
      await race.drop(
        'map.zip',
        zipOf([
          ['maps/readme.md', '# A map'],
          ['maps/small.yaml', YAML],
          ['maps/small.pgm', PGM],
        ]),
      )
      await expect(page.getByTestId('map-kind')).toContainText('ROS map')
      await open(page)
      expect((await race.session()).scenario.spec.world).toEqual(WORLD)
    })
    await undone(race, async () => {
      await race.drop('small.txt.gz', gzipSync('0 0 1\n0 0 0\n1 0 0\n'))
      await expect.poll(() => size(race)).toEqual([3, 3])
    })
    await race.drop('heights.zip', zipOf([['small.asc', ASC]]))
    await expect(page.getByTestId('terrain-dialog')).toBeVisible()
    await page.getByTestId('terrain-cancel').click()
    await race.drop(
      'nothing.zip',
      zipOf([
        ['a.md', '# no'],
        ['b.md', '# map'],
      ]),
    )
    await expect(page.getByTestId('toast-error')).toContainText('nothing.zip')
  })

  test('an archive within an archive is refused by its name', async ({ page }) => {
    const race = new RacePage(page)
    const inner = zipOf([['small.txt', '0 0 1\n0 0 0\n1 0 0\n']])
    await race.drop('outer.zip', zipOf([['inner.zip', inner]]))
    const refusal = page.getByTestId('toast-error')
    await expect(refusal).toContainText('The archive outer.zip holds another one, inner.zip')
    await expect(refusal).toContainText('Unpack the inner one first')
    await undone(race, async () => {
      const small = '0 0 1 0\n0 0 0 0\n1 0 0 0\n'
      await race.drop(
        'both.zip',
        zipOf([
          ['small.txt', small],
          ['inner.zip', inner],
        ]),
      )
      await expect.poll(() => size(race)).toEqual([4, 3])
      await expect(page.getByTestId('toast-warning')).toContainText('inner.zip')
    })
  })

  test('a slow read says so, and ends without a word once a newer one begins', async ({ page }) => {
    const race = new RacePage(page)
    const before = await size(race)
    await stallReads(page)
    const reading = page.getByTestId('toast-info').filter({ hasText: 'Reading slow.txt…' })
    await race.drop('slow.txt', '0 0 1 0 0\n0 0 0 0 0\n')
    await expect(reading).toBeVisible()
    await page.keyboard.press('Escape')
    await expect(reading).toHaveCount(0)
    await release(page)
    expect(await size(race)).toEqual(before)

    await race.drop('slow.txt', '0 0 1 0 0\n0 0 0 0 0\n')
    await expect(reading).toBeVisible()
    await race.drop('quick.txt', '0 0 1\n0 0 0\n1 0 0\n')
    await expect.poll(() => size(race)).toEqual([3, 3])
    await expect(reading).toHaveCount(0)
    await release(page)
    await expect(page.getByTestId('toast-success')).toHaveCount(1)
    expect(await size(race)).toEqual([3, 3])
  })

  test('of several maps one is chosen', async ({ page }) => {
    const race = new RacePage(page)
    await undone(race, async () => {
      await race.dropTogether([
        ['one.txt', '0 0 1\n0 0 0\n1 0 0\n'],
        ['two.txt', '0 0 1 0\n0 0 0 0\n1 0 0 0\n'],
      ])
      await expect(page.getByTestId('map-file')).toHaveCount(2)
      await expectClean(page, 'several maps')
      await page.getByTestId('map-file').last().click()
      await expect.poll(() => size(race)).toEqual([4, 3])
      await expect(page.locator('dialog')).toHaveCount(0)
    })
  })

  test('a file that is none of ours does not keep the others from being opened', async ({
    page,
  }) => {
    const race = new RacePage(page)
    await race.dropTogether([
      ['letter.txt', 'Dear reader,\nthis is no map.\n'],
      ['small.yaml', YAML],
      ['small.pgm', PGM],
    ])
    await expect(page.getByTestId('map-kind')).toContainText('ROS map')
    await expect(page.getByTestId('toast-warning')).toContainText('letter.txt')
    await page.keyboard.press('Escape')
    await expect(dialog(page)).toBeHidden()
  })

  test('a dropped folder is looked through', async ({ page }) => {
    const race = new RacePage(page)
    const files = [
      ['small.yaml', YAML],
      ['small.pgm', PGM.toString('base64')],
      ['notes.md', '# Notes'],
    ]
    await page.evaluate((given) => {
      const entries = given.map(([name = '', content = '']) => {
        const bytes = name.endsWith('pgm')
          ? Uint8Array.from(atob(content), (char) => char.charCodeAt(0))
          : content
        const fullPath = `/maps/${name}`
        const file = (done: (file: File) => void) => done(new File([bytes], name))
        return { name, fullPath, isDirectory: false, isFile: true, file }
      })
      const folder = {
        name: 'maps',
        isDirectory: true,
        // One at a time, as a reader gives parts.
        createReader: () => ({
          readEntries: (done: (some: object[]) => void) => done(entries.splice(0, 1)),
        }),
      }
      const event = new Event('drop', { bubbles: true, cancelable: true })
      const items = [{ webkitGetAsEntry: () => folder }]
      Object.assign(event, { dataTransfer: { types: ['Files'], files: [], items } })
      document.querySelector('main')?.dispatchEvent(event)
    }, files)
    await expect(page.getByTestId('map-kind')).toContainText('ROS map')
    await open(page)
    expect(await size(race)).toEqual([6, 4])
  })

  test('what is known but not read here is refused by its name', async ({ page }) => {
    const race = new RacePage(page)
    const before = await race.session()
    await race.drop('paper.pdf', '%PDF-1.7\n')
    const toast = page.getByTestId('toast-error')
    await expect(toast).toContainText('PDF document')
    await expect(toast).toContainText('screenshot')
    await race.importByButton('map.npy', Buffer.from('\x93NUMPY\x01\0', 'latin1'))
    const alert = page.getByTestId('import-dialog').getByRole('alert')
    await expect(alert).toContainText('NumPy')
    await expect(alert).toContainText('np.savetxt')
    expect((await race.session()).scenario).toEqual(before.scenario)
  })
})

for (const scheme of ['light', 'dark'] as const) {
  test(`axe finds nothing serious in the dialog, and keys alone open a map (${scheme})`, async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme: scheme })
    const race = new RacePage(page)
    await race.openAtRest()
    await race.drop('plan.png', await floorPlan(page))
    await expect(page.getByTestId('map-blocked')).toContainText('120')
    await expectClean(page, 'picture')
    await page.getByTestId('map-threshold').focus()
    for (let step = 0; step < 30; step++) await page.keyboard.press('ArrowRight')
    await expect(page.getByTestId('map-blocked')).toContainText('220')
    await page.getByTestId('map-open').focus()
    await page.keyboard.press('Enter')
    await expect(dialog(page)).toBeHidden()
    expect(await size(race)).toEqual([60, 40])
    await race.dropTogether([
      ['small.yaml', YAML],
      ['small.pgm', PGM],
    ])
    await expect(page.getByTestId('map-size')).toContainText('6 × 4')
    await expectClean(page, 'robot')
    // Enter opens it, too, while no control has the focus.
    await page.keyboard.press('Enter')
    await expect(dialog(page)).toBeHidden()
    expect(await size(race)).toEqual([6, 4])
  })
}

test('the dialog fits a phone @phone', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.drop('plan.png', await floorPlan(page))
  await expect(page.getByTestId('map-blocked')).toContainText('120')
  await expectClean(page, 'phone')
  const overflow = await dialog(page)
    .locator('.dialog-content')
    .evaluate((content) => content.scrollWidth - content.clientWidth)
  expect(overflow).toBeLessThanOrEqual(0)
  await expect(page.getByTestId('map-open')).toBeInViewport()
})

test.describe('in Chinese', () => {
  test.use({ locale: 'zh-CN' })

  test('everything in the dialog is Chinese', async ({ page }) => {
    const race = new RacePage(page)
    await race.open()
    await race.dropTogether([
      ['small.yaml', YAML],
      ['small.pgm', PGM],
    ])
    await expect(page.getByTestId('map-notices')).toContainText('未知格视为障碍')
    // Texts that stand beside each other are words of their own.
    const words = await dialog(page).evaluate((part) => {
      const texts = document.createTreeWalker(part, NodeFilter.SHOW_TEXT)
      const all: (string | null)[] = []
      while (texts.nextNode()) all.push(texts.currentNode.nodeValue)
      return all.join(' ')
    })
    const latin = words.match(/[A-Za-z_]{2,}/g) ?? []
    expect(
      latin.filter(
        (word) => !/^(ROS|Nav|SmacPlanner|NavFn|small|yaml|image|resolution|origin)$/.test(word),
      ),
    ).toEqual([])
  })
})
