/** Panels and tools on the core engine. */
import * as engine from '@pkg/core/formicarium'
import { toolCalls } from './engine_calls'
import { serve } from './serve_worker'

serve(engine, toolCalls(engine))
