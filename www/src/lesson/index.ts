/** Lessons: stops, one ant, guesses, a path by hand, a target. One part of the page, fetched when it is first wanted. */
import '../styles/lesson.css'
import type { ComponentType } from 'preact'
import { addLessonWords } from '../i18n/lesson'
import { addPlaybackWords } from '../i18n/playback'
import type { LessonPiece } from '../state/lazy_parts'
import { Cards } from './cards'
import { LessonTools } from './lesson_tools'
import { OnMap } from './on_map'
import { TargetField } from './target_field'
import { TargetStrip } from './target_strip'

const ready = () => Promise.all([addLessonWords(), addPlaybackWords()])

const PIECES = {
  tools: LessonTools,
  map: OnMap,
  cards: Cards,
  target: TargetStrip,
  field: TargetField,
}

// biome-ignore lint/suspicious/noExplicitAny: each place knows what its piece takes
export const fetchPiece = (piece: LessonPiece): Promise<ComponentType<any>> =>
  ready().then(() => PIECES[piece])
