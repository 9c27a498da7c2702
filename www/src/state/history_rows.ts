/** The iteration history of one panel's run: rows of six numbers that only grow until the run is replaced. */
export const ROW = 6

export class HistoryRows {
  private buffer = new Float64Array(ROW * 128)
  count = 0

  append(rows: Float64Array): void {
    const end = this.count * ROW + rows.length
    if (end > this.buffer.length) {
      const grown = new Float64Array(Math.max(end, this.buffer.length * 2))
      grown.set(this.buffer)
      this.buffer = grown
    }
    this.buffer.set(rows, this.count * ROW)
    this.count = end / ROW
  }

  clear(): void {
    this.count = 0
  }

  at(row: number, column: number): number {
    return this.buffer[row * ROW + column] ?? Number.NaN
  }

  toArray(): Float64Array {
    return this.buffer.slice(0, this.count * ROW)
  }
}
