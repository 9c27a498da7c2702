/** The runs of the open comparison, as the engine numbers them. */
import type { Opened } from '../../model/comparison_calls'

export class Tasks {
  private readonly table: Uint32Array
  private readonly order: Uint32Array

  constructor({ tasks, order }: Pick<Opened, 'tasks' | 'order'>) {
    this.table = tasks
    this.order = order
  }

  /** In the order in which they are handed out: only the first `seeds` seeds of each entry; all where it is null. */
  inOrder(seeds: number | null = null): number[] {
    const taken = new Set<number>()
    const end = this.order.findIndex(
      (index) => taken.add(this.seedOf(index)).size > (seeds ?? Infinity),
    )
    return [...(end < 0 ? this.order : this.order.subarray(0, end))]
  }

  /** Place of its map in the question. */
  instanceOf(index: number): number {
    return this.table[3 * index] ?? 0
  }

  /** Place of its entry in the question. */
  entryOf(index: number): number {
    return this.table[3 * index + 1] ?? 0
  }

  seedOf(index: number): number {
    return this.table[3 * index + 2] ?? 0
  }

  /** The same for all runs of one entry on one map. */
  pairOf(index: number): string {
    return `${this.instanceOf(index)} ${this.entryOf(index)}`
  }
}
