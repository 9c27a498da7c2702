/** What a worker does for a robot that drives: it holds the drive that is on show. */
import type { Drive, DriveState, DriveStep, ParamSpec } from '@pkg/formicarium'
import type { Cell } from './cell'
import type { ParamValues, RunSetup } from './messages'

/** What a step tells besides the state after it. */
export type DroveStep = Pick<DriveStep, 'did' | 'at' | 'planned'>

/** Where a drive stands, and the steps since the answer before it. */
export interface Driven {
  state: DriveState
  steps: DroveStep[]
}

export interface DriveCalls {
  /** How a robot drives, as rows for controls. */
  driveParams(): ParamSpec[]
  /** A robot at the start; the former drive is forgotten. */
  startDrive(run: RunSetup, driving: ParamValues): Driven
  /** Up to so many steps, and none after so many milliseconds, but one at least. */
  advanceDrive(steps: number, milliseconds: number): Driven
  /** What it comes to, compared with the best in advance, which may take seconds to search for. */
  sumUpDrive(): Drive
  /** The best path where nothing moves; empty where there is none. */
  stillPath(run: RunSetup): Cell[]
}
