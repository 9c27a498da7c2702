/** A robot that drives where walls change and obstacles move. One part of the page, fetched when it is first wanted. */
import { addDriveWords } from '../i18n/drive'
import { addLessonWords } from '../i18n/lesson'
import { DriveCard } from './card'
import { DriveOnMap } from './on_map'

const ready = () => Promise.all([addDriveWords(), addLessonWords()])

export const fetchDriveCard = () => ready().then(() => DriveCard)
export const fetchDriveOnMap = () => ready().then(() => DriveOnMap)
export const fetchFitting = () => ready().then(() => import('./fit'))
