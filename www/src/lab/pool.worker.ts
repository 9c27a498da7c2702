/** Does the runs of one experiment, one at a time. */
import * as engine from '@pkg/formicarium'
import { answerCalls } from '../engine/answer'
import type { PoolCalls } from './pool'

let experiment: engine.Experiment | null = null

const seconds = () => performance.now() / 1000

const calls: PoolCalls = {
  open(document) {
    experiment?.free()
    experiment = null
    experiment = new engine.Experiment(document)
  },
  run(index) {
    if (!experiment) throw new Error('no experiment is open')
    return experiment.run(index, seconds)
  },
}

answerCalls(calls, (module) => engine.initSync({ module }))
