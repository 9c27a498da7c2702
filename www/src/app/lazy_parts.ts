/** Where the parts of the page are that lower layers ask for (state/lazy_parts.ts). */
import { effect } from '@preact/signals'
import { scaleOf } from '../model/world'
import { notifyError, recall, scenario } from '../state'
import { lazyParts, nameLazyParts } from '../state/lazy_parts'
import { whenAntsWalk } from './when_ants_walk'

nameLazyParts({
  walls: async () => (await import('../state/changing_walls')).startChangingWalls(),
  opener: () => import('../state/open_files'),
  leftSessions: () => import('../state/left_sessions'),
  lab: () => import('../lab'),
  relief: () => import('../relief/relief_stage'),
  names: async () => (await import('../panels/names')).namesPart(),
  editor: async () => (await import('../editor')).fetchEditor(),
  lesson: async (piece) => (await import('./lesson_parts')).fetchPiece(piece),
  inspector: async () => (await import('../playback')).fetchInspector(),
})

// The first map that has a scale brings what tells metres.
effect(() => {
  if (scenario.value && scaleOf(scenario.value.spec))
    void import('../words/metres').catch(notifyError)
})

// Who has chosen to keep the trails finds it so.
if (recall('formicarium.keepTrails')) whenAntsWalk(() => void lazyParts.walls().catch(notifyError))
