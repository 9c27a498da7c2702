/** Workers of a lesson: the runs on the page know nothing of them. */
import type { LessonCalls } from '../model/lesson_calls'
import { ToolBox } from './tools'

export type LessonBox = ToolBox<LessonCalls>

export const newLessonBox = (): LessonBox => new ToolBox<LessonCalls>('whole')
