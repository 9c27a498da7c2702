/** The card of what a lesson does now. Where it stands, beside or below the maps, is the column's place to say (app/column_place.tsx). */
import '../styles/lesson_card.css'
import { lessonMode } from '../state'
import { AntCard } from './ant_card'
import { DrawCard } from './draw_card'
import { GuessCard } from './guess_card'

export function Cards() {
  switch (lessonMode.value) {
    case 'follow':
      return <AntCard />
    case 'guess':
      return <GuessCard />
    case 'draw':
      return <DrawCard />
    default:
      return null
  }
}
