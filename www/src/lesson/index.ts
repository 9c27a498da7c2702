/** Lessons: stops, one ant, guesses, a path by hand, a target. One part of the page, fetched when it is first wanted. */
import '../styles/playback.css'
import '../styles/lesson.css'
import { addLessonWords } from '../i18n/lesson'
import { addPlaybackWords } from '../i18n/playback'
import { LessonTools } from './lesson_tools'
import { OnMap } from './on_map'
import { TargetField } from './target_field'
import { TargetStrip } from './target_strip'

const ready = Promise.all([addLessonWords(), addPlaybackWords()])

export const fetchTools = () => ready.then(() => LessonTools)
export const fetchOnMap = () => ready.then(() => OnMap)
export const fetchTargetStrip = () => ready.then(() => TargetStrip)
export const fetchTargetField = () => ready.then(() => TargetField)
