/** All figures, in the order in which they are shown. */
import { ablation } from './ablation'
import { convergence } from './convergence'
import { effort } from './effort'
import { FIGURES, type Figure, type FigureId, type Scene } from './figure'
import { gaps } from './gaps'
import { ranks } from './ranks'
import { targets } from './targets'
import { values } from './values'

const ALL: Record<FigureId, Figure> = {
  values,
  convergence,
  targets,
  effort,
  gaps,
  ablation,
  ranks,
}

/** In an ablation the figure of its effects comes first. */
export function figuresOf(analysis: Scene['analysis']): Figure[] {
  const all = FIGURES.map((id) => ALL[id]).filter((figure) => figure.suits(analysis))
  return [
    ...all.filter(({ id }) => id === 'ablation'),
    ...all.filter(({ id }) => id !== 'ablation'),
  ]
}
