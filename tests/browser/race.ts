/** The race as specs see it, whatever drives the browser: what is pressed on the page, and what it answers. */
import { expect } from '@playwright/test'
import type { Cell } from '../../www/src/model/cell'
import type { PanelResult, Scripting } from '../../www/src/model/scripting'
import type { Session } from '../../www/src/model/session'
import { placement } from '../../www/src/model/viewpoint'

declare global {
  interface Window {
    formicarium: Scripting
  }
}

/** A place in the window, in CSS pixels. */
export interface Point {
  x: number
  y: number
}

export interface Box extends Point {
  width: number
  height: number
}

const WHOLE_MAP = { zoom: 1, centreX: 0.5, centreY: 0.5 }

/** On the page: whether every panel's run is loaded. */
export const runsAreLoaded = () => {
  const all = window.formicarium?.session() && window.formicarium.results()
  return all?.every((one) => one.summary !== null) ?? false
}

export abstract class Race {
  /** Opens the page and waits until every panel's run is loaded. */
  abstract open(address?: string): Promise<void>
  abstract ready(): Promise<void>
  /** Presses the control with this test id, once it can be pressed. */
  abstract press(testId: string): Promise<void>
  /** Takes the pointer away from what was pressed. */
  abstract leave(): Promise<void>
  /** What a function says that runs on the page; it sees nothing but its argument. */
  abstract evaluate<R, A>(what: (argument: A) => R | Promise<R>, argument: A): Promise<R>

  ask<R>(what: () => R | Promise<R>): Promise<R> {
    return this.evaluate<R, null>(what, null)
  }

  /** Opens the page and brings every run back to its beginning. */
  async openAtRest(address = './'): Promise<void> {
    await this.open(address)
    await this.press('reset')
    // No hint of a button stays over the maps.
    await this.leave()
    await expect.poll(() => this.attribute('play', 'data-phase')).toBe('editing')
    // A run that has not been loaded yet has no moves either.
    await this.ready()
    await expect.poll(() => this.antMoves()).toBe(0)
  }

  attribute(testId: string, name: string): Promise<string | null> {
    return this.evaluate(
      ([id, attribute]) =>
        document.querySelector(`[data-testid="${id}"]`)?.getAttribute(attribute) ?? null,
      [testId, name] as const,
    )
  }

  async menu(menu: string, item: string): Promise<void> {
    await this.press(menu)
    await this.press(item)
  }

  results(): Promise<PanelResult[]> {
    return this.ask(() => window.formicarium?.results() ?? [])
  }

  async result(place: number): Promise<PanelResult> {
    const result = (await this.results())[place - 1]
    if (!result) throw new Error(`there is no panel ${place}`)
    return result
  }

  /** Moves of the finished iterations. */
  async antMoves(): Promise<number> {
    return (await this.result(1)).summary?.effort.ant_moves ?? 0
  }

  /** The session; cells, heights and factors cross from the page as plain numbers. */
  async session(): Promise<Session> {
    const plain = await this.ask(() => {
      const session = window.formicarium.session()
      return (
        session && {
          ...session,
          scenario: {
            ...session.scenario,
            cells: Array.from(session.scenario.cells),
            heights: session.scenario.heights && Array.from(session.scenario.heights),
            factors: session.scenario.factors && Array.from(session.scenario.factors),
          },
        }
      )
    })
    if (!plain) throw new Error('there is no session')
    const { cells, heights, factors, ...rest } = plain.scenario
    return {
      ...plain,
      scenario: {
        ...rest,
        cells: Uint8Array.from(cells),
        heights: heights && Float32Array.from(heights),
        factors: factors && Float32Array.from(factors),
      },
    }
  }

  async isWall([x, y]: Cell): Promise<boolean> {
    const { spec, cells } = (await this.session()).scenario
    return cells[y * spec.width + x] === 1
  }

  async walls(): Promise<number> {
    return (await this.session()).scenario.cells.reduce((sum, cell) => sum + cell, 0)
  }

  /** Where a panel's map lies in the window. */
  async box(place = 1): Promise<Box> {
    const box = await this.evaluate((place) => {
      const stage = document.querySelector(`[data-testid="panel-${place}"] .stage`)
      const { x, y, width, height } = stage?.getBoundingClientRect() ?? new DOMRect()
      return { x, y, width, height }
    }, place)
    if (!box.width) throw new Error('the stage is not on screen')
    return box
  }

  /** Scrolls a panel's map to the middle of the window. */
  toMiddle(place = 1): Promise<void> {
    return this.evaluate((place) => {
      const stage = document.querySelector(`[data-testid="panel-${place}"] .stage`)
      stage?.scrollIntoView({ block: 'center' })
    }, place)
  }

  /** The middle of a cell on the page, while the whole map is in view. */
  async pointOf(cell: Cell, place = 1): Promise<Point> {
    // A map that changes its size is drawn with the next frame.
    await this.frame()
    const box = await this.box(place)
    const dpr = await this.ask(() => devicePixelRatio)
    const [width, height] = [Math.round(box.width * dpr), Math.round(box.height * dpr)]
    const { spec } = (await this.session()).scenario
    const { scale, originX, originY } = placement(WHOLE_MAP, { width, height, dpr }, spec)
    return {
      x: box.x + (originX + (cell[0] + 0.5) * scale) / dpr,
      y: box.y + (originY + (cell[1] + 0.5) * scale) / dpr,
    }
  }

  /** Lets the page draw and act once. */
  async frame(): Promise<void> {
    await this.ask(
      () =>
        new Promise<void>((resolve) => {
          requestAnimationFrame(() => requestAnimationFrame(() => resolve()))
        }),
    )
  }
}
