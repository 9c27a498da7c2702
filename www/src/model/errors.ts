/** Errors as they cross worker boundaries: always a plain EngineError object. */
import type { EngineError } from '@pkg/formicarium'

export function isEngineError(value: unknown): value is EngineError {
  return (
    typeof value === 'object' &&
    value !== null &&
    'kind' in value &&
    'message' in value &&
    'hint' in value
  )
}

/** What was thrown, as an EngineError; anything but the engine's own errors counts as a crash. */
export function toEngineError(thrown: unknown): EngineError {
  if (isEngineError(thrown)) return thrown
  return crash(thrown instanceof Error ? thrown.message : String(thrown))
}

export function crash(message: string): EngineError {
  return {
    kind: 'engine-crashed',
    field: '',
    message: `The engine stopped: ${message}`,
    hint: 'Nothing you drew is lost. Reset to start the engine again.',
    args: { reason: message },
  }
}

/** A part of the page, or of the engine, did not arrive. */
export function unreachable(why = ''): EngineError {
  const reason = why && ` (${why})`
  return {
    kind: 'part-unreachable',
    field: '',
    message: `This part of the page could not be fetched${reason}`,
    hint: 'Check the connection and try again. Nothing on the page is lost.',
    args: { reason },
  }
}

/** A file of this page is not there any more: a newer version has taken its place. */
export function outdated(): EngineError {
  return {
    kind: 'page-outdated',
    field: '',
    message:
      'A newer version of this page has been put in its place, and a part of this one is gone.',
    hint: 'Reload to get it. The map, the planners and their values are kept; runs begin anew.',
    args: {},
  }
}
