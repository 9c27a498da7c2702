/** Back, Forward and addresses: between Watch, Compare, a comparison and its tabs. */
import { type Browser, expect, type Page, test } from '@playwright/test'
import { ComparisonPage, documentText, holdRunsAfter, letRuns } from './comparison_page'
import { RacePage } from './race_page'

const SMALL = documentText({ entries: [{ id: 'ants', planner: 'ant-system' }], seeds: 3 })

const fragment = (page: Page) => new URL(page.url()).hash
const chosenTab = (page: Page) => page.locator('[role="tab"][aria-selected="true"]')

/** Runs a small comparison from Compare as it stands, by the form. */
async function compareSmall(page: Page): Promise<void> {
  const comparison = new ComparisonPage(page)
  await comparison.ready()
  await comparison.compare('astar')
  await comparison.seeds(2)
  await comparison.run()
  await comparison.finished()
}

async function toResultByHand(page: Page): Promise<void> {
  await new RacePage(page).openAtRest()
  await page.getByTestId('view-lab').click()
  await compareSmall(page)
}

test('Back and Forward go through Watch, Compare, a result and its tabs', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.drag([
    [4, 19],
    [9, 19],
  ])
  await page.getByTestId('step-iteration').click()
  await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  const [walls, moves] = [await race.walls(), await race.antMoves()]
  await page.getByTestId('view-lab').click()
  await compareSmall(page)
  await expect.poll(() => fragment(page)).toMatch(/^#lab\/[\w-]+$/)
  const result = fragment(page)
  const title = (await page.getByTestId('run-bar').getByRole('heading').textContent()) ?? ''
  await page.getByTestId('results-tab-files').click()
  await expect.poll(() => fragment(page)).toBe(`${result}/files`)
  await expect(page).toHaveTitle(`Files · ${title} · Formicarium`)
  await page.getByTestId('results-tab-figures').click()

  await page.goBack()
  await expect(chosenTab(page)).toHaveText('Files')
  await page.goBack()
  await expect(chosenTab(page)).toHaveText('Overview')
  await expect(page).toHaveTitle(`${title} · Formicarium`)
  await page.goBack()
  await expect(page.getByTestId('builder')).toBeVisible()
  expect(fragment(page)).toBe('#lab')
  await expect(page).toHaveTitle('Compare · Formicarium')
  await page.goBack()
  await expect(page.getByTestId('play')).toBeVisible()
  expect(fragment(page)).toBe('')
  expect([await race.walls(), await race.antMoves()]).toEqual([walls, moves])
  await expect(page).toHaveTitle(/race on your map/)

  await page.goForward()
  await expect(page.getByTestId('builder')).toBeVisible()
  await page.goForward()
  await expect(page.getByTestId('results')).toBeVisible()
  await page.goForward()
  await page.goForward()
  await expect(chosenTab(page)).toHaveText('Figures')
  expect(fragment(page)).toBe(`${result}/figures`)
})

test('several steps at once end at the last one', async ({ page }) => {
  await toResultByHand(page)
  const result = fragment(page)
  await page.getByTestId('results-tab-files').click()
  await page.getByTestId('lab-back').click()
  await expect(page.getByTestId('builder')).toBeVisible()
  await page.evaluate(async () => {
    for (const by of [-1, -1, -1, 2]) {
      const gone = new Promise((resolve) => addEventListener('popstate', resolve, { once: true }))
      history.go(by)
      await gone
    }
  })
  await expect.poll(() => fragment(page)).toBe(`${result}/files`)
  await expect(chosenTab(page)).toHaveText('Files')
})

test('each place opens again when it is reloaded, and Back still works', async ({ page }) => {
  await toResultByHand(page)
  const result = fragment(page)
  await page.getByTestId('results-tab-files').click()
  await page.reload()
  await expect(chosenTab(page)).toHaveText('Files')
  await page.goBack()
  await expect(chosenTab(page)).toHaveText('Overview')
  await page.reload()
  await expect(chosenTab(page)).toHaveText('Overview')
  expect(fragment(page)).toBe(result)
  await page.goBack()
  await expect(page.getByTestId('builder')).toBeVisible()
  await page.reload()
  await expect(page.getByTestId('builder')).toBeVisible()
  expect(fragment(page)).toBe('#lab')
  await page.goBack()
  await expect(page.getByTestId('play')).toBeVisible()
  await page.reload()
  await expect(page.getByTestId('play')).toBeVisible()
  await page.goForward()
  await expect(page.getByTestId('builder')).toBeVisible()
  await page.goForward()
  await expect(chosenTab(page)).toHaveText('Overview')
})

test('going between Watch and an open result is one step', async ({ page }) => {
  await toResultByHand(page)
  const result = fragment(page)
  await page.getByTestId('view-race').click()
  await page.getByTestId('view-lab').click()
  await expect.poll(() => fragment(page)).toBe(result)
  await page.goBack()
  await expect(page.getByTestId('play')).toBeVisible()
  await page.goBack()
  await expect(page.getByTestId('results')).toBeVisible()
  expect(fragment(page)).toBe(result)
})

test.describe('an address', () => {
  test('of a comparison opens in another tab of the same browser', async ({ browser }) => {
    const context = await browser.newContext()
    const page = await context.newPage()
    await toResultByHand(page)
    const other = await context.newPage()
    await other.goto(`${page.url()}/files`)
    await expect(chosenTab(other)).toHaveText('Files')
    await other.goto('about:blank')
    await other.goto(`${page.url()}/of-tomorrow`)
    await expect(chosenTab(other)).toHaveText('Overview')
    await expect.poll(() => fragment(other)).toBe(fragment(page))
    await context.close()
  })

  test('of a comparison that is not here says so, and shows Compare', async ({ page }) => {
    await page.goto('./#lab/never-was/tests')
    await expect(page.getByTestId('builder')).toBeVisible()
    await expect(page.getByTestId('toast-warning')).toContainText('not there any more')
    await expect.poll(() => fragment(page)).toBe('#lab')
  })

  test('as it was before addresses had ids opens what the tab had open', async ({ page }) => {
    await toResultByHand(page)
    // A visit of an older version: the tab remembers its comparison, the address says nothing of it.
    await page.goto('about:blank')
    await page.goto('./#lab')
    await expect(page.getByTestId('results')).toBeVisible()
    await expect.poll(() => fragment(page)).toMatch(/^#lab\/[\w-]+$/)
  })

  test('does not bring back who has left it before it was there', async ({ page }) => {
    await toResultByHand(page)
    await page.goto('about:blank')
    // What the browser keeps comes late.
    await page.addInitScript(() => {
      const { get } = IDBObjectStore.prototype
      IDBObjectStore.prototype.get = function (key) {
        const asked = get.call(this, key)
        if (this.name !== 'studies') return asked
        document.documentElement.dataset.asked = 'yes'
        const waiting: ((event: Event) => void)[] = []
        const { addEventListener } = asked
        asked.addEventListener = (type: string, listener: never, options?: never) => {
          if (type !== 'success') addEventListener.call(asked, type, listener, options)
          else waiting.push(listener)
        }
        addEventListener.call(asked, 'success', (event) => {
          setTimeout(() => {
            for (const tell of waiting) tell(event)
            const { dataset } = document.documentElement
            dataset.told = `${Number(dataset.told ?? 0) + 1}`
          }, 1000)
        })
        return asked
      }
    })
    await page.goto('./#lab')
    await expect(page.locator('html')).toHaveAttribute('data-asked', 'yes')
    await page.getByTestId('view-race').click()
    // It is asked for twice: whether it is there, and to be opened. What follows takes a moment.
    await expect(page.locator('html')).toHaveAttribute('data-told', '2')
    await page.waitForTimeout(500)
    await expect(page.getByTestId('view-race')).toHaveAttribute('aria-pressed', 'true')
    await page.getByTestId('view-lab').click()
    await expect(page.getByTestId('results')).toBeVisible()
    await page.goBack()
    await expect(page.getByTestId('panel-1')).toBeVisible()
  })
})

test.describe('a link written into the address', () => {
  test('opens, and Back brings back what was drawn before', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    const link = await race.shareLink()
    await race.menu('map-menu', 'gallery-open-field')
    await expect.poll(() => race.walls()).toBe(0)
    await race.drag([[20, 12]])
    await expect.poll(() => race.walls()).toBe(1)
    await page.evaluate((hash) => {
      location.hash = hash
    }, new URL(link).hash)
    await expect.poll(() => race.walls()).toBeGreaterThan(1)
    const ofLink = await race.walls()
    await race.drag([[4, 12]])
    await page.goBack()
    await expect.poll(() => race.walls()).toBe(1)
    await page.goForward()
    await expect.poll(() => race.walls()).toBeGreaterThan(ofLink - 1)
  })

  test('stays as it was changed, through Compare and back', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    const link = await race.shareLink()
    await race.openAtRest(link)
    const before = await race.walls()
    await race.drag([[20, 12]])
    const drawn = await race.walls()
    expect(drawn).not.toBe(before)
    await page.getByTestId('view-lab').click()
    await expect(page.getByTestId('builder')).toBeVisible()
    await page.goBack()
    await expect(page.getByTestId('play')).toBeVisible()
    expect(fragment(page)).toMatch(/^#x=/)
    expect(await race.walls()).toBe(drawn)
  })

  test('opens from the middle of Compare', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    const { hash } = new URL(await race.shareLink())
    await page.getByTestId('view-lab').click()
    await compareSmall(page)
    await page.evaluate((link) => {
      location.hash = link
    }, hash)
    await expect(page.getByTestId('play')).toBeVisible()
    await page.goBack()
    await expect(page.getByTestId('results')).toBeVisible()
  })

  test('that cannot be opened leaves what is there', async ({ page }) => {
    const race = new RacePage(page)
    await race.openAtRest()
    await race.drag([[20, 12]])
    const walls = await race.walls()
    await page.evaluate(() => {
      location.hash = '#x=rubbish'
    })
    await expect(page.getByTestId('toast-error')).toBeVisible()
    await page.goBack()
    await expect.poll(() => fragment(page)).toBe('')
    expect(await race.walls()).toBe(walls)
  })
})

test('Back closes an open dialog and stays where it was', async ({ page }) => {
  await new RacePage(page).openAtRest()
  await page.getByTestId('view-lab').click()
  await expect(page.getByTestId('builder')).toBeVisible()
  await page.getByTestId('help').click()
  await expect(page.locator('dialog')).toBeVisible()
  await page.evaluate(() => history.back())
  await expect(page.locator('dialog')).toHaveCount(0)
  await expect.poll(() => fragment(page)).toBe('#lab')
  await expect(page.getByTestId('builder')).toBeVisible()
  await page.goBack()
  await expect(page.getByTestId('play')).toBeVisible()
})

test('Back from runs under way keeps those that are done, and says so', async ({ page }) => {
  await holdRunsAfter(page, 2)
  const comparison = new ComparisonPage(page)
  await comparison.open()
  await comparison.compare('astar')
  await comparison.seeds(6)
  await comparison.run()
  await expect.poll(() => comparison.done()).toBe(2)
  await page.goBack()
  await expect(page.getByTestId('builder')).toBeVisible()
  await expect(page.getByTestId('toast-info')).toContainText('2 runs are kept')
  await page.goForward()
  await expect.poll(() => comparison.phase()).toBe('paused')
  expect(await comparison.done()).toBe(2)
  await letRuns(page)
  await page.getByTestId('lab-go-on').click()
  await comparison.finished()
})

/** A page whose browser stores nothing of comparisons. */
async function withoutStorage(browser: Browser): Promise<Page> {
  const page = await (await browser.newContext()).newPage()
  await page.addInitScript(() => {
    IDBFactory.prototype.open = () => {
      throw new DOMException('no storage', 'InvalidStateError')
    }
  })
  return page
}

test('what the browser does not store lives as long as the page, and leaving asks', async ({
  browser,
}) => {
  const page = await withoutStorage(browser)
  await new ComparisonPage(page).open()
  await compareSmall(page)
  await page.goBack()
  await expect(page.getByTestId('builder')).toBeVisible()
  await page.goForward()
  await expect(page.getByTestId('results')).toBeVisible()
  await expect.poll(() => new ComparisonPage(page).done()).toBe(2)
  const asked = page.waitForEvent('dialog')
  const closing = page.close({ runBeforeUnload: true })
  const dialog = await asked
  expect(dialog.type()).toBe('beforeunload')
  const closed = page.waitForEvent('close')
  await dialog.accept()
  await Promise.all([closing, closed])
  await page.context().close()
})

test('what is stored does not ask', async ({ page }) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.drag([[20, 12]])
  await expect
    .poll(() => page.evaluate(() => sessionStorage.getItem('formicarium.session')))
    .not.toBeNull()
  let asked = false
  page.on('dialog', (dialog) => {
    asked = true
    void dialog.accept()
  })
  await page.close({ runBeforeUnload: true })
  expect(asked).toBe(false)
})

test('what was drawn and could not be stored asks', async ({ page }) => {
  await page.addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException('full', 'QuotaExceededError')
    }
  })
  const race = new RacePage(page)
  await race.openAtRest()
  await race.drag([[20, 12]])
  await expect(page.getByTestId('undo')).toBeEnabled()
  /** Whether the page would ask, by the event that browsers send before leaving it. */
  const asks = () =>
    page.evaluate(() => !dispatchEvent(new Event('beforeunload', { cancelable: true })))
  // The session is stored a moment after the last change.
  await expect.poll(asks).toBe(true)
  await page.getByTestId('undo').click()
  await expect.poll(asks).toBe(false)
})

test('a comparison in a link gets an address of its own', async ({ browser, page }) => {
  await new ComparisonPage(page).open()
  await new ComparisonPage(page).script({ document: SMALL })
  await page.getByTestId('lab-share').click()
  const field = page.getByTestId('lab-share-link')
  await expect(field).toHaveValue(/#q=/)
  const link = await field.inputValue()
  const other = await (await browser.newContext()).newPage()
  await other.goto(link)
  await expect(other.getByTestId('results')).toBeVisible()
  await expect.poll(() => fragment(other)).toMatch(/^#lab\/[\w-]+$/)
  await other.reload()
  await expect(other.getByTestId('results')).toBeVisible()
  await other.context().close()
})
