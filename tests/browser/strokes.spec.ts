/** Walls come to be exactly under the finger, on every screen: nothing on the page moves while one draws. */
import { expect, test } from '@playwright/test'
import { Fingers, RacePage } from './race_page'
import { drawsWhereItIs, SCREENS } from './stroke'

for (const [width, height] of SCREENS)
  for (const running of [false, true])
    test(`a finger draws where it is, ${running ? 'while it runs' : 'at rest'}, on ${width} × ${height} @phone`, async ({
      page,
    }) => {
      await page.setViewportSize({ width, height })
      const race = new RacePage(page)
      await race.openAtRest()
      await drawsWhereItIs(race, await Fingers.on(page), running)
    })

test('while one draws, the picture follows and the page waits; then it begins anew @phone', async ({
  page,
}) => {
  const race = new RacePage(page)
  await race.openAtRest()
  await race.menu('map-menu', 'gallery-open-field')
  await expect.poll(() => race.walls()).toBe(0)
  await page.getByTestId('play').click()
  await expect.poll(() => race.antMoves()).toBeGreaterThan(0)
  await race.toMiddle()
  const fingers = await Fingers.on(page)
  const [from, to] = [await race.pointOf([15, 11]), await race.pointOf([20, 11])]
  await fingers.down(from)
  await fingers.move(to)
  for (let i = 0; i < 10; i++) await race.frame()
  await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'running')
  expect(await race.walls()).toBe(0)
  await fingers.up()
  await expect.poll(() => race.walls()).toBe(6)
  await expect(page.getByTestId('play')).toHaveAttribute('data-phase', 'editing')
  await expect(page.getByTestId('toast-info')).toBeVisible()
})
