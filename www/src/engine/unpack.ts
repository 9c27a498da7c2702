/** Archives, unpacked in a worker of their own that ends afterwards: no other call waits, and the memory goes with it. */
import type { Unpacked } from '@pkg/formicarium'
import type { MapCalls } from '../model/tool_calls'
import { ToolBox } from './tools'

/** The files of an archive, with their paths in it. */
export async function unpack(bytes: Uint8Array, name: string): Promise<Unpacked[]> {
  const box = new ToolBox<MapCalls>('whole')
  try {
    return await box.call('unpack', bytes, name)
  } finally {
    box.terminate()
  }
}
