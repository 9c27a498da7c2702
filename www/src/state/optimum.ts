/** Keeps the proven optimum and the engine's remarks in step with the scenario. */
import { effect } from '@preact/signals'
import { toEngineError } from '../engine/errors'
import { tools } from '../engine/tools'
import type { Scenario } from '../session'
import { optimum, scenario, scenarioNotices } from './store'

/** Long enough that a drag does not ask for every cell it crosses. */
const SETTLE_MS = 150

export function watchScenario(): void {
  let timer = 0
  effect(() => {
    const now = scenario.value
    optimum.value = null
    clearTimeout(timer)
    if (now) timer = window.setTimeout(() => void examine(now), SETTLE_MS)
  })
}

async function examine(asked: Scenario): Promise<void> {
  const [notices, length] = await Promise.all([remarks(asked), provenLength(asked)])
  if (scenario.peek() !== asked) return
  scenarioNotices.value = notices
  optimum.value = length
}

async function remarks(asked: Scenario) {
  try {
    return await tools.check(asked.spec, asked.cells)
  } catch (thrown) {
    const { kind, message, args } = toEngineError(thrown)
    return [{ kind, message, args }]
  }
}

/** A scenario that cannot be used has no optimum; why, the remarks say. */
async function provenLength(asked: Scenario): Promise<number | null> {
  try {
    return await tools.optimum(asked)
  } catch {
    return null
  }
}
