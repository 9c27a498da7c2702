/** What the checks ask of a browser beside Chromium: a window with the race in it, and a pointer. */
import type { Race } from '../race'
import type { Finger } from '../stroke'

export interface OtherBrowser {
  /** Name and version. */
  readonly name: string
  readonly race: Race
  readonly finger: Finger
  /** What the finger is to the page: the nearest to a touch that the browser's driver can do. */
  readonly pointerType: 'touch' | 'pen'
  /** Gives the page a view of this size. */
  resize(width: number, height: number): Promise<void>
  close(): Promise<void>
}
