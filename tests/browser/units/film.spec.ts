/** Which moment a frame shows, where things stand in it, and how its file grows. */
import { expect, test } from '@playwright/test'
import { layOut, type Rect } from '../../../www/src/film/frame_layout'
import { GrowingFile } from '../../../www/src/film/growing_file'
import {
  CODE_SECONDS,
  evenSize,
  framesOf,
  momentOf,
  RESULT_SECONDS,
  SIZES,
  secondsOf,
  speedFor,
} from '../../../www/src/film/settings'
import { evenly, thinned } from '../../../www/src/film/step_moments'
import { linkOfFilm } from '../../../www/src/share/film_text'

const PACE = { rate: 30, last: 100, perSecond: 20 } as const

test('frames begin at the beginning, show every moment in order, and end with the last', () => {
  for (const pace of [PACE, { ...PACE, perSecond: 7 }, { ...PACE, perSecond: 400 }])
    for (const unit of ['iteration', 'move'] as const) {
      const frames = framesOf(pace)
      const all = Array.from({ length: frames }, (_, i) => momentOf(i, { ...pace, unit }))
      expect(all[0]).toEqual({ at: 0, glide: 1, last: false, code: false })
      expect(all.at(-1)).toEqual({ at: 100, glide: 1, last: true, code: true })
      const places = all.map(({ at, glide }) => at + glide)
      expect(places).toEqual([...places].sort((a, b) => a - b))
      expect(all.filter(({ code }) => code)).toHaveLength(CODE_SECONDS * pace.rate)
      const still = all.filter(({ last, code }) => last && !code)
      expect(still.length).toBeGreaterThanOrEqual(RESULT_SECONDS * pace.rate)
    }
})

test('a film takes as long as it is to', () => {
  for (const seconds of [7, 12.5, 60, 600]) {
    const perSecond = speedFor(seconds, PACE)
    expect(Math.abs(secondsOf({ ...PACE, perSecond }) - seconds)).toBeLessThan(2 / PACE.rate)
  }
})

test('sizes are even and within limits', () => {
  expect(evenSize({ width: 321, height: 9 })).toEqual({ width: 322, height: 160 })
  expect(evenSize({ width: 99_999, height: 719.2 })).toEqual({ width: 3840, height: 720 })
})

test('steps begin and end the run, and are no more than asked for', () => {
  expect(evenly(12, 5)).toEqual([0, 3, 6, 9, 12])
  expect(evenly(2, 24)).toEqual([0, 1, 2])
  expect(thinned([3, 7], 12, 8)).toEqual([0, 3, 7, 12])
  const many = thinned(
    Array.from({ length: 90 }, (_, i) => i + 1),
    100,
    6,
  )
  expect(many).toHaveLength(6)
  expect([many[0], many.at(-1)]).toEqual([0, 100])
})

test('nothing in a frame lies over anything else or beyond its edges', () => {
  const overlap = (a: Rect, b: Rect) =>
    a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height
  const sizes = [...SIZES, { width: 320, height: 240 }]
  const maps = [
    { width: 36, height: 22 },
    { width: 10, height: 200 },
    { width: 300, height: 20 },
  ]
  const wrong = sizes.flatMap((size) =>
    maps.flatMap((map) =>
      [1, 2, 3, 6].flatMap((count) =>
        [0, 0.3, 0.5].flatMap((code) => {
          const layout = layOut(size, { count, map, titleLines: 2, code })
          const places = layout.panels.map(({ map: place }) => place)
          if (layout.code) places.push(layout.code.square)
          const top = layout.title.y + layout.title.height - 1
          const isWrong = ({ x, y, width, height }: Rect, i: number) =>
            x < 0 ||
            y < top ||
            x + width > size.width ||
            y + height > size.height ||
            places.slice(i + 1).some((other) => overlap({ x, y, width, height }, other))
          return places.some(isWrong) ? [{ size, map, count, code }] : []
        }),
      ),
    ),
  )
  expect(wrong).toEqual([])
})

test('a file grows by parts, and what is written over them counts', async () => {
  const file = new GrowingFile()
  const writer = file.writable.getWriter()
  const write = (position: number, text: string) =>
    writer.write({ position, data: new TextEncoder().encode(text) })
  await write(0, 'abcdef')
  await write(6, 'ghi')
  await write(1, 'BC')
  await write(8, 'IJK')
  await write(13, 'z')
  await writer.close()
  const whole = file.whole('video/webm')
  expect(await whole.text()).toBe('aBCdefghIJK\0\0z')
  expect(whole.type).toBe('video/webm')
})

test('a film tells its link from either end of it', () => {
  const link = 'https://example.org/f/#x=AZ_-9'
  const around = (before: number, after: number) =>
    new TextEncoder().encode(`${'\0'.repeat(before)}comment\n${link}\n${'\0'.repeat(after)}`)
  expect(linkOfFilm(around(40, 900_000))).toBe(link)
  expect(linkOfFilm(around(900_000, 40))).toBe(link)
  expect(linkOfFilm(new Uint8Array(9000))).toBeNull()
})
