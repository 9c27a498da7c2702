/** The card of what a lesson does now. Where it stands, beside or below the maps, is the column's place to say (app/column_place.tsx). */
import '../styles/lesson_card.css'
import { guide, inRelief, lessonMode } from '../state'
import { lazily } from '../ui/lazily'
import { AntCard } from './ant_card'
import { DrawCard } from './draw_card'
import { GuessCard } from './guess_card'

/** With the words of the gallery. */
const GuideCard = lazily(async () => (await import('./guide_card')).GuideCard)

export function Cards() {
  switch (inRelief.value ? null : lessonMode.value) {
    case 'follow':
      return <AntCard />
    case 'guess':
      return <GuessCard />
    case 'draw':
      return <DrawCard />
    default:
      return guide.value && <GuideCard id={guide.value} />
  }
}
