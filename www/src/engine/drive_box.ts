/** A worker of its own for a drive: the race knows nothing of it. */
import type { DriveCalls } from '../model/drive_calls'
import { ToolBox } from './tools'

export type DriveBox = ToolBox<DriveCalls>

export const newDriveBox = (): DriveBox => new ToolBox<DriveCalls>('whole')
