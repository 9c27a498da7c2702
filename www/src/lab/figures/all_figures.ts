/** All figures, in the order in which they are shown. */
import { t } from '../../i18n/lab'
import { ablation } from './ablation'
import { convergence } from './convergence'
import { effort } from './effort'
import type { Figure, FigureId, Scene } from './figure'
import { fronts } from './fronts'
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

/** What the mark behind a name means is said below every figure that shows such an entry. */
function withMarkNote(figure: Figure): Figure {
  const draw: Figure['draw'] = (plot, scene) => {
    const drawing = figure.draw(plot, scene)
    const shown = figure.overall ? scene.analysis.instances : [scene.map]
    const marked = shown.some(({ entries }) => entries.some(({ impossible }) => impossible > 0))
    const notes = marked ? [...drawing.notes, t('lab.matrix.markNote')] : drawing.notes
    return { ...drawing, notes }
  }
  return { ...figure, draw }
}

const NOTED = Object.values(ALL).map(withMarkNote)

/** On a tab of its own. */
export const frontsFigure = withMarkNote(fronts)

/** In an ablation the figure of its effects comes first. */
export function figuresOf(analysis: Scene['analysis']): Figure[] {
  const all = NOTED.filter((figure) => figure.suits(analysis))
  return [
    ...all.filter(({ id }) => id === 'ablation'),
    ...all.filter(({ id }) => id !== 'ablation'),
  ]
}
