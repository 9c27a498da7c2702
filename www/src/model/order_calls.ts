/** What a worker does for one order problem: it holds the run that is on show. */
import type { OrderBound, OrderFacts, OrderSummary } from '@pkg/formicarium'
import type { ParamValues } from './messages'

/** What a run of the order colony depends on. */
export interface OrderSettings {
  /** Tours end at their last place instead of returning. */
  open: boolean
  seed: number
  params: ParamValues
}

export interface OrderCalls {
  readOrder(bytes: Uint8Array, open: boolean, tour: Uint8Array | null): OrderFacts
  /** Begins a run; the former one is forgotten. */
  startOrder(bytes: Uint8Array, settings: OrderSettings): OrderSummary
  /** Up to so many iterations, and none after so many milliseconds, but one at least. */
  advanceOrder(iterations: number, milliseconds: number): OrderSummary
  /** Goes on with the search from the run's best tour, and for so many milliseconds; null where there is none. */
  searchOrder(milliseconds: number): OrderBound | null
  /** From, to and share of the largest of every strong trail. */
  orderTrails(): Float64Array
}
