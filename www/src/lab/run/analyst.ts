/** The worker that keeps all runs of the open comparison. */
import { workerAt } from '../../engine/new_worker'
import { ToolBox } from '../../engine/tools'
import type { AnalystCalls } from '../../model/comparison_calls'
import analystUrl from '../../worker/analyst.worker?worker&url'

export type Analyst = ToolBox<AnalystCalls>

export const newAnalyst = (): Analyst => new ToolBox<AnalystCalls>('whole', workerAt(analystUrl))
