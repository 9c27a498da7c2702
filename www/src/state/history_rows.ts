/** The iteration history of one panel's run: rows of six numbers that only grow until the run is replaced. */
export const ROW = 6
/** The column of the best length so far; infinite while there is none. */
export const BEST_SO_FAR = 1

export class HistoryRows {
  private buffer = new Float64Array(ROW * 128)
  count = 0
  /** Whether there has been a path, on this map or before a change of it. */
  hasPath = false

  append(rows: Float64Array): void {
    const end = this.count * ROW + rows.length
    if (end > this.buffer.length) {
      const grown = new Float64Array(Math.max(end, this.buffer.length * 2))
      grown.set(this.buffer)
      this.buffer = grown
    }
    this.buffer.set(rows, this.count * ROW)
    this.count = end / ROW
    for (let at = BEST_SO_FAR; at < rows.length && !this.hasPath; at += ROW)
      this.hasPath = Number.isFinite(rows[at])
  }

  clear(): void {
    this.count = 0
    this.hasPath = false
  }

  at(row: number, column: number): number {
    return this.buffer[row * ROW + column] ?? Number.NaN
  }

  toArray(): Float64Array {
    return this.buffer.slice(0, this.count * ROW)
  }
}
