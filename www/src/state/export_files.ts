/** The map and the session as files. */
import type { ExportFormat, RosFiles } from '@pkg/formicarium'
import { lateTools } from '../engine/late_tools'
import { notifyError } from './notices'
import { currentSession } from './sessions'
import { engineVersion, scenario } from './store'

export function exportMap(format: ExportFormat): Promise<string> {
  const now = scenario.peek()
  if (!now) return Promise.resolve('')
  // A .scen names the file of its map: the one that is downloaded.
  const named =
    format === 'movingai-scen' ? { ...now, spec: { ...now.spec, name: fileStem() } } : now
  return lateTools.exportMap(named, format)
}

export async function exportGeotiff(): Promise<Uint8Array> {
  const now = scenario.peek()
  return now ? lateTools.exportGeotiff(now) : new Uint8Array()
}

/** A map for ROS's map_server: its description, and the picture that it names. */
export async function exportRos(): Promise<RosFiles | null> {
  const now = scenario.peek()
  return now && lateTools.exportRos(now, `${fileStem()}.pgm`)
}

export async function exportSession(): Promise<string> {
  const { sessionToFile } = await import('../share/link')
  const session = currentSession()
  return session ? sessionToFile(session, engineVersion.peek()) : ''
}

export function download(
  name: string,
  content: string | Uint8Array | Blob,
  type = 'text/plain',
): void {
  const url = URL.createObjectURL(new Blob([content as BlobPart], { type }))
  const anchor = document.createElement('a')
  anchor.href = url
  anchor.download = name
  anchor.click()
  setTimeout(() => URL.revokeObjectURL(url), 10_000)
  if (isInSandbox())
    import('./sandboxed_download').then(
      ({ tellOfDownload }) => tellOfDownload(content),
      notifyError,
    )
}

/** In a frame without an origin: there downloads vanish without a word, unless the page around it allows them. */
const isInSandbox = () => window.origin === 'null' && window.parent !== window

/** The scenario's name, made fit for any file system. */
export function fileStem(): string {
  const name = scenario.peek()?.spec.name ?? ''
  return (
    name
      .replace(/\.\w+$/, '')
      .replace(/[^\p{L}\p{N}]+/gu, '-')
      .replace(/^-|-$/g, '')
      .toLowerCase() || 'map'
  )
}
