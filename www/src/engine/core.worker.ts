/** Panels and tools on the core engine. */
import * as engine from '@pkg/core/formicarium'
import { serve } from './serve'
import { toolCalls } from './tool_calls'

serve(engine, toolCalls(engine))
