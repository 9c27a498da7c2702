/** A worker of its own for an order problem: nothing else waits behind its iterations. */
import type { OrderCalls } from '../model/order_calls'
import { ToolBox } from './tools'

export type OrderBox = ToolBox<OrderCalls>

export const newOrderBox = (): OrderBox => new ToolBox<OrderCalls>('whole')
