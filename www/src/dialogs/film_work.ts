/** What goes on behind the dialog of films: previews, making, giving up. */
import type { Signal } from '@preact/signals'
import { useEffect, useRef, useState } from 'preact/hooks'
import { CopiedRace } from '../film/copied_race'
import { type Encoding, encodingFor } from '../film/encode'
import type { RaceLink } from '../film/link_of_race'
import { type Made, makeFilm } from '../film/make_film'
import { makeSteps } from '../film/make_steps'
import { Studio } from '../film/studio'
import { notifyError } from '../state'
import { fileStem } from '../state/export_files'
import { type Draft, filmOf, previewOf, stepsOf } from './film_draft'

/** Undefined while the browser is being asked; null where it has none. */
export function useEncoding({ width, height, rate }: Draft): Encoding | null | undefined {
  const [known, setKnown] = useState<{ key: string; encoding: Encoding | null } | null>(null)
  const key = `${width} ${height} ${rate}`
  useEffect(() => {
    let wanted = true
    encodingFor({ width, height }, rate).then(
      (encoding) => wanted && setKnown({ key, encoding }),
      (error) => {
        if (!wanted) return
        setKnown({ key, encoding: null })
        notifyError(error)
      },
    )
    return () => {
      wanted = false
    }
  }, [key])
  return known?.key === key ? known.encoding : undefined
}

/** While something is typed, nothing is drawn yet. */
const RESTED_MS = 200

/** Draws the first or last frame onto a canvas; tells whether it is there. */
export function usePreview(draft: Draft, link: Promise<RaceLink>, first: boolean, active: boolean) {
  const canvas = useRef<HTMLCanvasElement>(null)
  const { settings, frame } = previewOf(draft, first)
  const key = active ? JSON.stringify([settings, first]) : ''
  const [shown, setShown] = useState('')
  useEffect(() => {
    if (!active) return
    let race: CopiedRace | null = null
    let wanted = true
    const draw = async () => {
      race = await CopiedRace.of(settings.panels)
      if (!race || !wanted) return race?.end()
      const studio = await Studio.of(race, settings, await link)
      await studio.draw(frame)
      race.end()
      if (!wanted) return
      show(canvas.current, studio.canvas)
      setShown(key)
    }
    const timer = setTimeout(() => draw().catch((error) => wanted && notifyError(error)), RESTED_MS)
    return () => {
      wanted = false
      clearTimeout(timer)
      race?.end()
    }
  }, [key])
  return { canvas, isReady: shown !== '' && shown === key }
}

/** Pixels: more are not seen in a dialog. */
const PREVIEW_WIDTH = 1280

/** Shows a frame in the dialog. */
export function show(canvas: HTMLCanvasElement | null, frame: OffscreenCanvas): void {
  if (!canvas) return
  const fit = Math.min(1, PREVIEW_WIDTH / Math.max(frame.width, frame.height))
  canvas.width = Math.round(frame.width * fit)
  canvas.height = Math.round(frame.height * fit)
  const context = canvas.getContext('2d')
  if (context) context.imageSmoothingQuality = 'high'
  context?.drawImage(frame, 0, 0, canvas.width, canvas.height)
}

export type Work =
  /** `error`: why nothing came of the last attempt. */
  | { phase: 'choosing'; error?: unknown }
  | { phase: 'making'; done: number; frames: number }
  | { phase: 'ready'; name: string; made: Made }

/** Often enough to be followed. */
const TOLD_MS = 120

/** Makes what the draft says; resolves when it is there or has been given up. */
export async function make(
  draft: Draft,
  linkMade: Promise<RaceLink>,
  encoding: Encoding | null,
  work: Signal<Work>,
  canvas: HTMLCanvasElement | null,
  signal: AbortSignal,
): Promise<void> {
  let told = 0
  const onFrame = (done: number, frames: number, frame?: OffscreenCanvas) => {
    if (signal.aborted || (performance.now() - told < TOLD_MS && done < frames)) return
    told = performance.now()
    work.value = { phase: 'making', done, frames }
    if (frame) show(canvas, frame)
  }
  work.value = { phase: 'making', done: 0, frames: 0 }
  try {
    const link = await linkMade
    const stem = `${fileStem()}-${draft.what}`
    const made =
      draft.what !== 'film'
        ? await makeSteps(stepsOf(draft), link, stem, { signal, onFrame })
        : encoding && (await makeFilm(filmOf(draft), encoding, link, { signal, onFrame }))
    if (signal.aborted) return
    work.value = made
      ? { phase: 'ready', name: `${stem}.${made.ending}`, made }
      : { phase: 'choosing' }
  } catch (error) {
    if (signal.aborted) return
    work.value = { phase: 'choosing', error }
  }
}
