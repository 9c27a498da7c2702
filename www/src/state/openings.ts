/** One opening of files at a time: a newer one ends the older, and none takes a dialog away that asks about a file. */
import { t } from '../i18n/dialogs'
import { tellInDialog } from './dialog_notice'
import { openDialog } from './dialogs'
import { dismiss, notify } from './notices'
import { mapChoice, mapFile, scenChoice, terrainFile } from './offered_files'

/** Reading that takes no longer is not worth a word. */
const SILENT_MS = 400
/** More names than these are only hinted at. */
const MOST_NAMED = 3

/** An opening under way. */
export class Turn {
  private notice: number | null = null
  private readonly timer: ReturnType<typeof setTimeout>
  private over = false

  constructor(names: string[]) {
    const told = () => {
      this.notice = notify('info', t('opening.reading', { names: listed(names) }), { stays: true })
    }
    this.timer = setTimeout(told, SILENT_MS)
  }

  /** Whether a newer one has begun, or the reader has given this one up. */
  get isOver(): boolean {
    return this.over
  }

  /** To be asked after every wait, before anything on the page changes; throws once it is over. */
  check(): void {
    if (this.over) throw new Error('the opening is over')
  }

  /** Nothing is being read any more. */
  rest(): void {
    clearTimeout(this.timer)
    if (this.notice !== null) dismiss(this.notice)
    this.notice = null
  }

  end(): void {
    this.over = true
    this.rest()
  }
}

let current: Turn | null = null

/** Opens in a turn of its own, which ends an older one. False if it was itself ended: without a word. */
export async function inTurn(
  names: string[],
  open: (turn: Turn) => Promise<void>,
): Promise<boolean> {
  current?.end()
  const turn = new Turn(names)
  current = turn
  const onKey = (event: KeyboardEvent) => {
    if (event.key === 'Escape' && !document.querySelector('dialog[open], :popover-open')) turn.end()
  }
  addEventListener('keydown', onKey)
  try {
    await open(turn)
    return !turn.isOver
  } catch (error) {
    if (turn.isOver) return false
    throw error
  } finally {
    removeEventListener('keydown', onKey)
    turn.rest()
  }
}

/** Whether a dialog about a file waits for the reader. */
export const isAsking = () =>
  [mapFile, terrainFile, mapChoice, scenChoice].some((offered) => offered.peek() !== null) ||
  openDialog.peek() === 'order'

export function tellNotOpened(names: string[]): void {
  if (names.length > 0)
    tellInDialog(t('opening.answerFirst', { count: names.length, names: listed(names) }))
}

function listed(names: string[]): string {
  const shown = names.slice(0, MOST_NAMED).join(', ')
  return names.length > MOST_NAMED ? `${shown}, …` : shown
}
