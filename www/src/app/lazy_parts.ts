/** Where the parts of the page are that lower layers ask for (state/lazy_parts.ts). */
import { nameLazyParts } from '../state/lazy_parts'

nameLazyParts({
  opener: () => import('../state/open_files'),
  leftSessions: () => import('../state/left_sessions'),
  lab: () => import('../lab'),
  relief: () => import('../relief/relief_stage'),
  names: async () => (await import('../panels/names')).namesPart(),
  editor: async () => (await import('../editor')).fetchEditor(),
  lesson: async (piece) => (await import('../lesson')).fetchPiece(piece),
  inspector: async () => (await import('../playback')).fetchInspector(),
})
