/** The worker's side of an order problem. */
import type * as whole from '@pkg/formicarium'
import type { OrderCalls } from '../model/order_calls'

type Engine = Pick<typeof whole, 'read_order' | 'OrderRun'>

export function orderCalls(engine: Engine): OrderCalls {
  let run: whole.OrderRun | null = null
  const begun = () => {
    if (!run) throw new Error('no run has begun')
    return run
  }
  return {
    readOrder: (bytes, open, tour) => engine.read_order(bytes, open, tour),
    startOrder(bytes, { open, seed, params }) {
      const next = new engine.OrderRun(bytes, open, params, seed)
      run?.free()
      run = next
      return next.summary()
    },
    advanceOrder(iterations, milliseconds) {
      const end = performance.now() + milliseconds
      for (let i = 0; i < iterations; i++)
        if (!begun().advance(1) || performance.now() >= end) break
      return begun().summary()
    },
    searchOrder(milliseconds) {
      const end = performance.now() + milliseconds
      let bound = begun().search() ?? null
      while (bound && !bound.finished && performance.now() < end) bound = begun().search() ?? null
      return bound
    },
    orderTrails: () => begun().trails(),
  }
}
