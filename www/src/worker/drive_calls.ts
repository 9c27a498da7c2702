/** The worker's side of a drive. */
import type * as whole from '@pkg/formicarium'
import type { DriveCalls, Driven } from '../model/drive_calls'
import type { ParamValues, RunSetup } from '../model/messages'

type Engine = Pick<typeof whole, 'DriveRun' | 'drive_params'>

export function driveCalls(engine: Engine): DriveCalls {
  let run: whole.DriveRun | null = null
  const begun = () => {
    if (!run) throw new Error('no drive has begun')
    return run
  }
  const made = (setup: RunSetup, driving: ParamValues) => {
    const { spec, cells, heights, factors, planner, params, seed } = setup
    return new engine.DriveRun(spec, cells, heights, factors, planner, params, seed, driving)
  }
  return {
    driveParams: () => engine.drive_params(),
    startDrive(setup, driving) {
      const next = made(setup, driving)
      run?.free()
      run = next
      return { state: next.state(), steps: [] }
    },
    advanceDrive: (count, milliseconds) => advance(begun(), count, milliseconds),
    sumUpDrive: () => begun().summary(),
    stillPath(setup) {
      const still = made(setup, {})
      still.step(1)
      const { path } = still.state()
      still.free()
      return path
    },
  }
}

function advance(run: whole.DriveRun, count: number, milliseconds: number): Driven {
  const ends = performance.now() + milliseconds
  const steps: Driven['steps'] = []
  for (let i = 0; i < count; i++) {
    const [step] = run.step(1)
    if (!step) break
    const { did, at, planned } = step
    steps.push({ did, at, ...(planned && { planned }) })
    if (performance.now() >= ends) break
  }
  return { state: run.state(), steps }
}
