/** One figure: drawn as wide as there is room, also as a table, and as files to download. */
import { useSignal } from '@preact/signals'
import { FileCode2, Image, Table2 } from 'lucide'
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks'
import { framed } from '../../figures/frame'
import { type Ground, LOOKS } from '../../figures/look'
import { downloadSvg } from '../../figures/picture_files'
import { language } from '../../i18n'
import { t } from '../../i18n/lab'
import { inSentences } from '../../i18n/lists'
import type { Analysis, MapAnalysis, MapFronts } from '../../model/analysis'
import { notifyError, theme } from '../../state'
import { Button } from '../../ui/buttons'
import { fileStem } from '../store/names'
import { shownComparison } from '../store/shown_comparison'
import { openComparison, phase } from '../store/signals'
import { DataTable } from './data_table'
import { downloadPng, figureFile } from './download'
import type { Figure, Plot, Scene } from './figure'

interface FigureCardProps {
  figure: Figure
  plot: Plot
  analysis: Analysis
  map: MapAnalysis
  logarithmic: boolean
  /** Of downloads. */
  ground: Ground
  fronts?: MapFronts
}

export function FigureCard(props: FigureCardProps) {
  const { figure, analysis, map, logarithmic, fronts } = props
  const asTable = useSignal(false)
  const width = useSignal(0)
  const host = useRef<HTMLDivElement>(null)
  useEffect(() => watchWidth(host.current, (now) => (width.value = now)), [])
  const look = LOOKS[theme.value]
  const scene: Scene = { analysis, map, logarithmic, look, width: width.value, fronts }
  const missing = figure.missing(scene)
  const title = titleOf(figure, scene)
  return (
    <section class="figure-card" aria-label={title} data-testid={`figure-${figure.id}`}>
      <header class="figure-head">
        <h3>{title}</h3>
        {!missing && <Actions {...props} scene={scene} asTable={asTable} />}
      </header>
      <div ref={host} class="figure-host">
        {missing && <p class="figure-missing">{t(missing)}</p>}
        {!missing && asTable.value && <DataTable {...figure.table(scene)} caption={title} />}
        {!missing && !asTable.value && width.value > 0 && <Picture {...props} scene={scene} />}
      </div>
    </section>
  )
}

function watchWidth(
  host: HTMLElement | null,
  tell: (width: number) => void,
): (() => void) | undefined {
  if (!host) return
  const resized = new ResizeObserver(() => tell(Math.floor(host.clientWidth)))
  resized.observe(host)
  return () => resized.disconnect()
}

/** While runs go on, a figure waits this many times as long as it took to draw: the page has other work. */
const REST = 20

function Picture({ figure, plot, scene }: FigureCardProps & { scene: Scene }) {
  const frame = useRef<HTMLDivElement>(null)
  const notBefore = useRef(0)
  const { analysis, map, width, look, logarithmic, fronts } = scene
  useLayoutEffect(() => {
    const draw = () => {
      const began = performance.now()
      const words = inSentences([titleOf(figure, scene), figure.words(scene)])
      try {
        const drawing = figure.draw(plot, scene)
        frame.current?.replaceChildren(framed(drawing, width, look, words, null))
      } catch (error) {
        notifyError(error)
      }
      notBefore.current = performance.now() + REST * (performance.now() - began)
    }
    const wait = phase.peek() === 'running' ? notBefore.current - performance.now() : 0
    if (wait <= 0) return draw()
    const timer = setTimeout(draw, wait)
    return () => clearTimeout(timer)
  }, [figure, plot, analysis, map, width, look, logarithmic, fronts, language.value])
  return <div ref={frame} class="figure-picture" />
}

type Toggled = FigureCardProps & { scene: Scene; asTable: { value: boolean } }

function Actions({ figure, plot, scene, ground, asTable }: Toggled) {
  const file = () => figureFile(plot, figure, scene, headingOf(figure, scene), ground)
  const stem = () => {
    const about = figure.overall ? '' : `-${scene.map.id}`
    return `${fileStem(openComparison.value?.title ?? '')}-${figure.id}${about}`
  }
  const save = (how: (svg: SVGSVGElement, stem: string) => void | Promise<void>) => () => {
    file()
      .then((svg) => how(svg, stem()))
      .catch(notifyError)
  }
  return (
    <div class="figure-actions">
      <Button
        icon={Table2}
        label={t('lab.results.asTable')}
        tone="quiet"
        pressed={asTable.value}
        testId={`figure-${figure.id}-table`}
        onClick={() => {
          asTable.value = !asTable.value
        }}
      />
      <Button
        icon={FileCode2}
        label="SVG"
        tone="quiet"
        testId={`figure-${figure.id}-svg`}
        onClick={save(downloadSvg)}
      />
      <Button
        icon={Image}
        label="PNG"
        tone="quiet"
        testId={`figure-${figure.id}-png`}
        onClick={save(downloadPng)}
      />
    </div>
  )
}

const titleOf = (figure: Figure, { map }: Scene) =>
  figure.overall
    ? t(`lab.results.figures.${figure.id}`)
    : `${t(`lab.results.figures.${figure.id}`)} · ${map.name}`

/** Of a picture that leaves the page: what it shows, and of what. */
function headingOf(figure: Figure, { map, analysis }: Scene) {
  const runs = Math.max(0, ...map.entries.map(({ runs }) => runs))
  const about = figure.overall
    ? t('lab.results.onMaps', { count: analysis.instances.length })
    : map.name
  const parts = [
    shownComparison.value?.title ?? '',
    about,
    t('lab.results.runsEach', { count: runs }),
  ]
  return {
    title: t(`lab.results.figures.${figure.id}`),
    subtitle: parts.filter((part) => part !== '').join(' · '),
  }
}
