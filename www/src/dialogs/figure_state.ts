/** A picture read as the figure of a grid: what was found, what was corrected, and the way back. */
import type { Figure, Imported, Lattice, Shown } from '@pkg/formicarium'
import { useEffect, useMemo, useRef, useState } from 'preact/hooks'
import { FigureReader } from '../engine/figures'
import type { MapFile } from '../state'
import { corrected, type Draft, withLattice } from './figure_draft'
import { latticeOver } from './figure_lattice'
import { useLatest } from './latest_answer'

export interface FigureState {
  /** Null until its pixels are here. */
  shown: Shown | null
  /** Null while a lattice is looked for. */
  draft: Draft | null
  /** What was found; null while it is looked for, and where there is none. */
  found: Lattice | null
  /** What the cells of the draft's lattice are, with what was corrected; null until they are read. */
  classes: Uint8Array | null
  read: Figure | null
  /** Whether the lattice was found, or something was set by hand. */
  isPlaced: boolean
  error: unknown
  /** Changes the draft; changes of the same gesture (a drag) are undone together. */
  change: (draft: Draft, gesture?: number) => void
  canUndo: boolean
  /** Takes the last change back; with a gesture, only if that was the last. */
  undo: (gesture?: number) => void
  /** The map as it was corrected. */
  take: () => Promise<Imported>
}

interface Drafts {
  now: Draft | null
  before: Draft[]
  gesture: number | undefined
}

/** `asked`: the reader wants a figure; `idle`: nothing else is to be read, so a lattice may be looked for unasked. */
export function useFigure(file: MapFile, asked: boolean, idle: boolean): FigureState {
  const [begun, setBegun] = useState(false)
  const [shown, setShown] = useState<Shown | null>(null)
  const [found, setFound] = useState<Lattice | null>(null)
  const [broken, setBroken] = useState<unknown>(null)
  const [drafts, setDrafts] = useState<Drafts>({ now: null, before: [], gesture: undefined })
  const reader = useRef<FigureReader | null>(null)
  if (!begun && (asked || idle)) setBegun(true)

  useEffect(() => {
    if (!begun) return
    const own = new FigureReader(file.bytes)
    reader.current = own
    const begin = (lattice: Lattice) =>
      setDrafts({ now: withLattice(lattice), before: [], gesture: undefined })
    const look = async () => {
      const picture = await own.show()
      setShown(picture)
      try {
        const { lattice } = await own.find()
        setFound(lattice)
        begin(lattice)
      } catch (error) {
        if ((error as { kind?: string }).kind === 'engine-crashed') throw error
        begin(latticeOver(picture.width, picture.height))
      }
    }
    look().catch(setBroken)
    return () => own.end()
  }, [begun])

  const { now, before } = drafts
  const lattice = now?.lattice ?? null
  const ask = asked && lattice ? () => (reader.current as FigureReader).read(lattice) : null
  const { answer, settled, error } = useLatest(ask ? JSON.stringify(lattice) : '', ask)
  const read = settled && ask && error === null ? answer : null
  const classes = useMemo(() => read && now && corrected(read.classes, now), [read, now])
  return {
    shown,
    draft: now,
    found,
    classes,
    read,
    isPlaced: found !== null || before.length > 0,
    error: broken ?? error,
    change: (draft, gesture) =>
      setDrafts((old) => {
        const goesOn = gesture !== undefined && gesture === old.gesture
        return {
          now: draft,
          before: goesOn || !old.now ? old.before : [...old.before, old.now],
          gesture,
        }
      }),
    canUndo: before.length > 0,
    undo: (gesture) =>
      setDrafts((old) => {
        const last = old.before.at(-1)
        const meant = gesture === undefined || gesture === old.gesture
        return last && meant
          ? { now: last, before: old.before.slice(0, -1), gesture: undefined }
          : old
      }),
    take: () => {
      if (!reader.current || !classes || !read) throw new Error('the cells are not read yet')
      return reader.current.map(classes, read.lattice.columns, file.name)
    },
  }
}
