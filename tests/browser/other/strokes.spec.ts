/** Walls come to be exactly under the finger in the other browsers, too. */
import { expect } from '@playwright/test'
import { drawsWhereItIs, SCREENS } from '../stroke'
import { test } from './browsers'

declare global {
  interface Window {
    /** What pressed last on the page. */
    pressedBy: string
  }
}

/** One screen is drawn on with every change; all of them in a mode of its own. */
const [USUAL] = SCREENS

for (const [width, height] of SCREENS)
  for (const running of [false, true])
    test(`a stroke is where it was drawn, ${running ? 'while it runs' : 'at rest'}, on ${width} × ${height}`, {
      tag: width === USUAL[0] && height === USUAL[1] ? [] : ['@every-screen'],
    }, async ({ other }) => {
      const { race } = other
      await other.resize(width, height)
      await race.openAtRest()
      await race.ask(() =>
        addEventListener('pointerdown', (event) => {
          window.pressedBy = event.pointerType
        }),
      )
      await drawsWhereItIs(race, other.finger, running)
      expect(await race.ask(() => window.pressedBy)).toBe(other.pointerType)
    })
