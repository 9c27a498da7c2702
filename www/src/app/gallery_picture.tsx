/** A built-in map as a small picture. Fetched with the first look into the menu of maps. */
import '../styles/map_thumb.css'
import { type Signal, signal } from '@preact/signals'
import { useEffect } from 'preact/hooks'
import { MapPicture } from '../dialogs/map_picture'
import { gallery } from '../gallery/gallery'
import type { Scenario } from '../model/session'

/** Made once; null while they are on their way. */
const pictures = new Map<string, Signal<Scenario | null>>()

/** One after the other: most of them wait for the engine, and none may keep it from what the reader asks for meanwhile. */
let queue = Promise.resolve()

function pictureOf(id: string): Signal<Scenario | null> {
  const known = pictures.get(id)
  if (known) return known
  const made = signal<Scenario | null>(null)
  pictures.set(id, made)
  const make = async () => {
    made.value = (await gallery.find((entry) => entry.id === id)?.scenario()) ?? null
  }
  // Without a picture the map is there all the same, and the next look tries again.
  queue = queue.then(make).catch(() => void pictures.delete(id))
  return made
}

export function GalleryPicture({ id }: { id: string }) {
  const map = pictureOf(id)
  useEffect(() => void pictureOf(id), [id])
  if (!map.value) return null
  const { width, height } = map.value.spec
  return (
    <span class="map-thumb" style={{ '--aspect': width / height }}>
      <MapPicture map={map.value} ends />
    </span>
  )
}
