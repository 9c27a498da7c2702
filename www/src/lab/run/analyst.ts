/** The worker that keeps all runs of the open comparison. */
import { ToolBox } from '../../engine/tools'
import type { AnalystCalls } from '../../model/comparison_calls'
import AnalystWorker from '../../worker/analyst.worker?worker'

export type Analyst = ToolBox<AnalystCalls>

export const newAnalyst = (): Analyst => new ToolBox<AnalystCalls>('whole', new AnalystWorker())
