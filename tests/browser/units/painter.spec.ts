/** When a panel's worker draws: of views that have come together the last one, and before the steps that came after them. */
import { expect, test } from '@playwright/test'
import type { PanelView } from '../../../www/src/model/messages'
import { Painter } from '../../../www/src/worker/painter'

const view = (width: number): PanelView => ({
  width,
  height: 9,
  scale: 1,
  originX: 0,
  originY: 0,
  dpr: 1,
  layer: 'none',
  ends: {},
  showAnts: true,
  showPath: true,
  showContours: true,
  hidden: false,
  theme: 'light',
  colour: '#000000',
  goalNames: [],
  cursor: null,
  cursorFocus: false,
})

test('the last of several views is drawn, before the step that came after them', async () => {
  const done: string[] = []
  /** As much of a canvas as is asked for where there is no map yet. */
  class Canvas {
    constructor(
      public width: number,
      public height: number,
    ) {}
    getContext = () => ({
      clearRect: (_x: number, _y: number, width: number) => done.push(`drawn, ${width} wide`),
    })
  }
  Object.assign(globalThis, { OffscreenCanvas: Canvas })
  const painter = new Painter(new OffscreenCanvas(1, 1), view(1), () => {})
  painter.afterView(() => done.push('first step'))
  painter.setView(view(5))
  painter.setView(view(7))
  painter.afterView(() => done.push('second step'))
  expect(done).toEqual(['first step'])
  await expect.poll(() => done.length).toBe(3)
  expect(done).toEqual(['first step', 'drawn, 7 wide', 'second step'])
  painter.afterView(() => done.push('third step'))
  expect(done.at(-1)).toBe('third step')
})
