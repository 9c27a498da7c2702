/** Does the runs of one comparison, one at a time. */
import * as engine from '@pkg/formicarium'
import type { PoolCalls } from '../model/comparison_calls'
import { answerCalls } from './answer_calls'

let comparison: engine.Comparison | null = null

const seconds = () => performance.now() / 1000

const calls: PoolCalls = {
  open(document) {
    comparison?.free()
    comparison = null
    comparison = new engine.Comparison(document)
  },
  run(index) {
    if (!comparison) throw new Error('no comparison is open')
    return comparison.run(index, seconds)
  },
}

answerCalls(calls, (module) => engine.initSync({ module }))
