/** The pieces of a lesson with those of a drive, which stands above it: each in the place that the page has for both. */
import { fetchPiece as fetchPieceOfLesson } from '../lesson'
import { lessonMode } from '../state'
import type { LessonPiece } from '../state/lazy_parts'
import { lazily } from '../ui/lazily'
import { offerDrives } from './offer_drive'

const DriveCard = lazily(async () => (await import('../drive')).fetchDriveCard())
const DriveOnMap = lazily(async () => (await import('../drive')).fetchDriveOnMap())

export async function fetchPiece(piece: LessonPiece): ReturnType<typeof fetchPieceOfLesson> {
  const Piece = await fetchPieceOfLesson(piece)
  switch (piece) {
    case 'tools':
      offerDrives()
      return Piece
    case 'cards':
      return (props) => (lessonMode.value === 'drive' ? <DriveCard /> : <Piece {...props} />)
    case 'map':
      return (props) => (
        <>
          <Piece {...props} />
          {lessonMode.value === 'drive' && <DriveOnMap {...props} />}
        </>
      )
    default:
      return Piece
  }
}
