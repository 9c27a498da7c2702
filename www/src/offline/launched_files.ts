/** Files that the system opens with the installed page (`file_handlers` of public/manifest.webmanifest). */
import { notifyError } from '../state'
import { lazyParts } from '../state/lazy_parts'

interface LaunchQueue {
  setConsumer(take: (launch: { files: FileSystemFileHandle[] }) => void): void
}

export function openLaunched(): void {
  const queue = (window as { launchQueue?: LaunchQueue }).launchQueue
  queue?.setConsumer(({ files }) => {
    if (files.length > 0) void open(files).catch(notifyError)
  })
}

async function open(handles: FileSystemFileHandle[]): Promise<void> {
  const files = await Promise.all(handles.map((handle) => handle.getFile()))
  await (await lazyParts.opener()).openFiles(files)
}
