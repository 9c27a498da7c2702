/**
 * A file that grows while it is written: whole parts are handed to the browser as they come, which may keep them on disk; what is
 * written over them later, at the end of a film, is put in its place then.
 */

interface Chunk {
  position: number
  data: Uint8Array<ArrayBuffer>
}

export class GrowingFile {
  private readonly parts: Blob[] = []
  private readonly later: Chunk[] = []
  size = 0

  readonly writable = new WritableStream<Chunk>({ write: (chunk) => this.write(chunk) })

  private write({ position, data }: Chunk): void {
    const behind = Math.max(0, this.size - position)
    const over = data.slice(0, behind)
    const added = data.slice(behind)
    if (over.length > 0) this.later.push({ position, data: over })
    if (position > this.size) this.append(new Uint8Array(position - this.size))
    if (added.length > 0) this.append(added)
  }

  private append(data: Uint8Array<ArrayBuffer>): void {
    this.parts.push(new Blob([data]))
    this.size += data.length
  }

  whole(type: string): Blob {
    let whole = new Blob(this.parts)
    for (const { position, data } of this.later)
      whole = new Blob([whole.slice(0, position), data, whole.slice(position + data.length)])
    return new Blob([whole], { type })
  }
}
