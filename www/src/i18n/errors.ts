/** Errors and remarks of the engine in the reader's language: by kind when there is a translation, else as the engine said it. */
import type { Notice } from '@pkg/formicarium'
import { engineText, phrase, t } from '.'

interface Described {
  message: string
  hint: string
}

interface Coded extends Described {
  kind: string
  field?: string
  args?: Record<string, string>
}

const CHINESE = /\p{Script=Han}/u

/** What an error tells in words of its own. */
const IN_WORDS = ['what', 'expected', 'max', 'found', 'value']

/** What browsers say, each in its own words, when a part of the page could not be fetched. */
const UNFETCHED = /dynamically imported module|importing a module script|unable to preload/i

export function describeError(error: unknown): Described {
  if (isCoded(error)) {
    const args: Record<string, string> = {
      ...error.args,
      ...groundOf(error),
      field: engineText(`paramNames.${error.field}`, phrase(error.field ?? '')),
    }
    for (const key of IN_WORDS) if (args[key]) args[key] = phrase(args[key])
    const known = `found.${args.found?.toLowerCase().replace(/[^a-z0-9]+/g, '-')}`
    if (args.found) args.found = engineText(`${known}.name`, args.found)
    const hint = engineText(`errors.${error.kind}.hint`, phrase(error.hint), args)
    return {
      message: sentence(engineText(`errors.${error.kind}.message`, error.message, args)),
      hint: sentence(engineText(`${known}.hint`, hint)),
    }
  }
  const message = error instanceof Error ? error.message : String(error)
  if (UNFETCHED.test(message))
    return { message: t('errors.unfetched'), hint: t('errors.unfetchedHint') }
  return { message: t('errors.unexpected', { message }), hint: t('errors.unexpectedHint') }
}

/** What is wrong and what to do, in one line. Chinese has no space between sentences. */
export function errorText(error: unknown): string {
  const { message, hint } = describeError(error)
  return message.endsWith('。') ? message + hint : `${message} ${hint}`
}

/** The engine names a ground by its id. */
function groundOf({ args }: Coded): { ground?: string } {
  return args?.ground ? { ground: engineText(`grounds.${args.ground}`, args.ground) } : {}
}

/** An error that came as a notice has its field among its arguments. */
export function describeNotice({ kind, message, args }: Notice): string {
  const told = engineText(`notices.${kind}`, '', { message: phrase(message), ...args })
  return told
    ? sentence(told)
    : describeError({ kind, message, hint: '', field: args.field, args }).message
}

function isCoded(error: unknown): error is Coded {
  return typeof error === 'object' && error !== null && 'kind' in error && 'hint' in error
}

/** The engine's messages start in lower case and have no full stop, so that they can follow a colon. */
function sentence(text: string): string {
  if (text === '') return text
  const capital = text.charAt(0).toUpperCase() + text.slice(1)
  if (/[.!?。！？]$/.test(capital)) return capital
  return capital + (CHINESE.test(capital) ? '。' : '.')
}
