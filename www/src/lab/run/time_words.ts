/** About how long something takes. Rounded: nobody counts the seconds of an hour. */
import { t } from '../../i18n/lab'

const KEYS = {
  left: ['lab.run.secondsLeft', 'lab.run.minutesLeft', 'lab.run.hoursLeft'],
  ofShare: ['lab.class.seconds', 'lab.class.minutes', 'lab.class.hours'],
} as const

/** `what`: that it is left to be waited for, or what a share takes. */
export function timeWords(seconds: number, what: keyof typeof KEYS): string {
  const [inSeconds, inMinutes, inHours] = KEYS[what]
  if (seconds < 90) return t(inSeconds, { count: Math.max(1, Math.ceil(seconds)) })
  if (seconds < 5400) return t(inMinutes, { count: Math.ceil(seconds / 60) })
  return t(inHours, { count: Math.ceil(seconds / 3600) })
}
