/**
 * Answers the page around this one. It hears its parent alone, from one origin alone, and answers to that origin: the one that the
 * address names or, where it names none, the one that the browser says the parent is from. docs/embedding.md has the contract.
 */
import {
  ARGUMENTS,
  type EventName,
  type Events,
  type Refusal,
  type RequestKind,
  type Sent,
  VERSION,
} from '../../model/embed_messages'
import { badOption, ScriptError, toScriptError } from '../../model/script_error'
import { flushLive } from '../../state'

type Request = Record<string, unknown> & { kind: RequestKind }

export interface Parent {
  tell<E extends EventName>(event: E, fields: Events[E]): void
}

/** Requests wait until `started`. `named` is the origin in the address; null where there is none. */
export function answerParent(named: string | null, started: Promise<unknown>): Parent {
  const origin = window.parent === window ? null : (named ?? originOfParent())
  if (origin !== null)
    addEventListener('message', ({ source, origin: from, data }) => {
      if (source !== window.parent || from !== origin || !isRequest(data)) return
      void started.then(() => answer(data)).then((answered) => post(origin, answered))
    })
  return {
    tell(event, fields) {
      if (origin !== null)
        post(origin, { formicarium: VERSION, kind: 'event', event, ...fields } as Sent)
      else if (event === 'ready' && window.parent !== window) post('*', BARE)
    },
  }
}

/** All that a page may know that has not said who it is. */
const BARE: Sent = { formicarium: VERSION, kind: 'event', event: 'ready' }

/** A parent without an origin, in a sandbox or from a file, must be named: nothing tells it from any other such page. */
function originOfParent(): string | null {
  const told = window.location.ancestorOrigins?.[0] ?? document.referrer
  try {
    const { origin } = new URL(told)
    return origin === 'null' ? null : origin
  } catch {
    return null
  }
}

function post(origin: string, message: Sent): void {
  const to = origin === 'null' ? '*' : origin
  try {
    window.parent.postMessage(message, to)
  } catch (error) {
    // What cannot be copied into another page.
    if (message.kind !== 'answer') throw error
    window.parent.postMessage(refusal(message.id, toScriptError(error)), to)
  }
}

function isRequest(data: unknown): data is Request {
  if (typeof data !== 'object' || data === null) return false
  const { formicarium, kind } = data as Record<string, unknown>
  return formicarium === VERSION && typeof kind === 'string' && Object.hasOwn(ARGUMENTS, kind)
}

async function answer(request: Request): Promise<Sent> {
  const { id } = request
  if (typeof id !== 'string' && typeof id !== 'number')
    return refusal(null, badOption('id', 'must be a text or a number'))
  try {
    const value = (await call(request)) ?? null
    // What the runs have come to is told before the answer that it belongs to.
    flushLive()
    return { formicarium: VERSION, kind: 'answer', id, value }
  } catch (error) {
    return refusal(id, toScriptError(error))
  }
}

async function call({ formicarium: _, kind, id: __, ...given }: Request): Promise<unknown> {
  const names: string[] = ARGUMENTS[kind]
  for (const name of Object.keys(given)) {
    if (names.includes(name)) continue
    const hint = names.length > 0 ? `It takes ${names.join(', ')}.` : 'It takes nothing.'
    throw new ScriptError('unknown-option', name, `${kind} takes no "${name}"`, hint)
  }
  const called: unknown = window.formicarium[kind]
  if (typeof called !== 'function') return called
  return called(...names.map((name) => given[name]))
}

function refusal(id: string | number | null, thrown: ScriptError): Sent {
  const { kind, field, message, hint } = thrown
  const error: Refusal = { kind, field, message, hint }
  return { formicarium: VERSION, kind: 'error', id, error }
}
