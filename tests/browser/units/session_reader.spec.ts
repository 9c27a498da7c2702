/** The command line reads what the page's own code writes: cells, heights in both forms, goals, values. */
import { writeFileSync } from 'node:fs'
import { expect, test } from '@playwright/test'
import type { Session } from '../../../www/src/model/session'
import { packBits } from '../../../www/src/share/codec'
import { seal } from '../../../www/src/share/envelope'
import { documentOf } from '../../../www/src/share/session_document'
import { cli, rowsOf, submit, trackerOf } from '../tracker_folder'
import { rolling, sessionOf, terrainOf } from './sessions'

const ENGINE = '0.1.0'
/** No run has it: a claim that is refused for it alone was read to the last bit. */
const REFUSED = 'the digest does not come out again: 0123456789abcdef is claimed'

/** With one panel that the engine can build, and ends that can be stood on. */
function runnable(session: Session): Session {
  const { cells } = session.scenario
  cells[0] = 0
  cells[cells.length - 1] = 0
  const [panel] = session.panels
  if (!panel) throw new Error('a session has a panel')
  const params = { ants: 5, rho: 0.3, dead_end: 'die' }
  return { ...session, panels: [{ ...panel, params }], layer: 'trail' }
}

const decimals = (width: number, height: number) =>
  Float32Array.from({ length: width * height }, (_, i) =>
    i % 17 === 5 ? Number.NaN : Math.fround(((i * 7919) % 4000) / 10 - 100),
  )

const SESSIONS: [string, () => Session][] = [
  ['a plane', () => sessionOf(13, 9)],
  ['a large plane', () => sessionOf(200, 150)],
  ['a terrain in decimals with gaps', () => terrainOf(20, 15, decimals(20, 15))],
  ['a terrain in floats', () => terrainOf(20, 15, rolling(20, 15, 400))],
]

test.describe('the command line reads', () => {
  test.skip(!cli, 'FORMICARIUM_CLI does not name the command line tool')

  for (const [what, make] of SESSIONS) {
    test(`${what} from a link and from a file`, async () => {
      const session = runnable(make())
      const folder = trackerOf(session.scenario)
      const link = `https://example.org/#x=${await seal(packBits(session, ENGINE))}`
      const { code, said } = submit(folder, link)
      expect(said).toContain(REFUSED)
      expect(code).toBe(1)

      const file = `${folder}/race.experiment.json`
      writeFileSync(
        file,
        JSON.stringify({ ...documentOf(session, ENGINE), ...rowsOf(session.scenario) }),
      )
      expect(submit(folder, file).said).toContain(REFUSED)
    })
  }

  test('another map as another one', async () => {
    const session = runnable(sessionOf(13, 9))
    const folder = trackerOf(session.scenario)
    session.scenario.cells[40] = 1 - (session.scenario.cells[40] ?? 0)
    const { code, said } = submit(folder, `#x=${await seal(packBits(session, ENGINE))}`)
    expect(said).toContain('its 13 × 9 cells are those of none')
    expect(code).toBe(2)
  })
})
