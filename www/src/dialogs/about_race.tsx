/** What a race that was sent is. */

import { ChartColumn, Dices, Play, Share2 } from 'lucide'
import { tools } from '../engine/tools'
import { numbers } from '../i18n'
import { t } from '../i18n/about'
import type { Verification } from '../model/scripting'
import type { RecordedResult } from '../model/session'
import {
  caption,
  engineVersion,
  notifyError,
  objectives,
  type Panel,
  panels,
  play,
  references,
  scenario,
  seed,
  setSeed,
  showView,
} from '../state'
import { closeDialog, show } from '../state/dialogs'
import { held } from '../state/memory'
import { gapOf, gapShown } from '../words/gap_words'
import { lengthShown } from '../words/lengths'
import { mapName } from '../words/map_names'
import { isSearch, labelsOf } from '../words/planner_words'
import { Citation, Facts, Offer, Section } from './about_parts'

export function AboutRace() {
  return (
    <>
      <Sent />
      <Verified />
      <HowGood />
      <Next />
      <Citation text={citation()} />
    </>
  )
}

const verifiedOf = ({ live }: Panel): Verification => live.value.verified
const recordedOf = ({ setup }: Panel): RecordedResult | null => setup.result
const labels = () => labelsOf(panels.value.map(({ setup }) => setup))

function Sent() {
  const { title, note } = caption.value
  return (
    <Section title={t('about.sent.title')}>
      {title && (
        <p class="about-name" dir="auto">
          {title}
        </p>
      )}
      {note && (
        <p class="about-note" dir="auto">
          {note}
        </p>
      )}
      <p>{t('about.sent.race')}</p>
      <Facts
        facts={[
          [t('about.sent.map'), t('about.sent.size', mapArgs())],
          [t('about.sent.seed'), String(seed.value), t('about.sent.seedHint')],
        ]}
      />
      <Runs />
    </Section>
  )
}

function mapArgs() {
  const { width = 0, height = 0 } = scenario.value?.spec ?? {}
  return { name: mapName(), width, height }
}

function Runs() {
  const names = labels()
  return (
    <div class="about-scroll">
      <table class="about-runs" data-testid="about-runs">
        <caption class="visually-hidden">{t('about.runs.caption')}</caption>
        <thead>
          <tr>
            {(['planner', 'length', 'gap', 'here'] as const).map((column) => (
              <th key={column} scope="col">
                {t(`about.runs.${column}`)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {panels.value.map((panel, at) => (
            <Run key={panel.id} panel={panel} name={names[at] ?? ''} />
          ))}
        </tbody>
      </table>
    </div>
  )
}

function Run({ panel, name }: { panel: Panel; name: string }) {
  const result = recordedOf(panel)
  const verified = verifiedOf(panel)
  const gap = result && gapOfRecorded(panel, result)
  return (
    <tr>
      <th scope="row">{name}</th>
      <td>
        {result ? lengthWords(result) : t('about.runs.none')}
        {result && !isSearch(panel.setup.planner) && (
          <span class="hint">
            {' '}
            {t('about.runs.after', {
              count: result.iterations,
              n: numbers.value.whole.format(result.iterations),
            })}
          </span>
        )}
      </td>
      <td>{gap == null ? t('about.runs.unknown') : gapShown(gap)}</td>
      <td data-verified={verified}>
        {verified === 'none' ? t('about.runs.unknown') : t(`about.runs.${verified}`)}
      </td>
    </tr>
  )
}

function lengthWords({ length, status }: RecordedResult): string {
  if (length !== null) return lengthShown(length)
  return t(status === 'running' ? 'about.runs.noPathYet' : 'about.runs.noPath')
}

/** A record has the length alone, so other objectives have no gap here. */
function gapOfRecorded({ live }: Panel, { length }: RecordedResult): number | null {
  return live.value.objective === 'length' ? gapOf(length, references.value.length ?? null) : null
}

function Verified() {
  return (
    <Section title={t('about.verified.title')}>
      <p class="about-answer" role="status" data-testid="about-verified">
        {t(`about.verified.${answer()}`)}
      </p>
      <p class="hint">{t('about.verified.how')}</p>
    </Section>
  )
}

function answer() {
  const all = panels.value.filter(recordedOf).map(verifiedOf)
  if (all.length === 0) return 'nothing'
  if (all.includes('differs')) return 'differs'
  if (all.every((one) => one === 'verified')) return 'all'
  return held.value ? 'held' : 'pending'
}

function HowGood() {
  const [objective] = objectives.value
  const reference = objective && references.value[objective]
  const value = reference && 'value' in reference ? reference.value : null
  const words = value === null || !reference ? 'unknown' : reference.kind
  const known = words === 'proven' || words === 'unproven' ? words : 'unknown'
  return (
    <Section title={t('about.gap.title')}>
      <p data-testid="about-best">{t(`about.gap.${known}`, { value: lengthShown(value ?? 0) })}</p>
      <p class="hint">{t('about.gap.how')}</p>
    </Section>
  )
}

function Next() {
  return (
    <Section title={t('about.next.title')}>
      <ul class="about-offers">
        <Offer
          icon={Play}
          label={t('about.next.play')}
          hint={t('about.next.playHint')}
          testId="about-play"
          onClick={() => {
            closeDialog()
            play()
          }}
        />
        <Offer
          icon={Dices}
          label={t('about.next.seed')}
          hint={t('about.next.seedHint')}
          testId="about-seed"
          onClick={() => {
            closeDialog()
            void tools.proposeSeed().then(setSeed, notifyError)
          }}
        />
        <Offer
          icon={ChartColumn}
          label={t('about.next.compare')}
          hint={t('about.next.compareHint')}
          testId="about-compare"
          onClick={() => {
            closeDialog()
            showView('lab')
          }}
        />
        <Offer
          icon={Share2}
          label={t('about.next.share')}
          hint={t('about.next.shareHint')}
          testId="about-share"
          onClick={() => show('share')}
        />
      </ul>
      <p class="hint">{t('about.next.add')}</p>
    </Section>
  )
}

/** The digest tells the rest. */
const DIGITS = 7

/** What somebody needs to say which result is meant. */
function citation(): string {
  const names = labels()
  const runs = panels.value.map((panel, at) =>
    runWords(panel.setup.planner, names[at] ?? '', recordedOf(panel)),
  )
  const { name, width, height } = mapArgs()
  const title = caption.value.title || name
  return t('about.cite.race', {
    engine: engineVersion.value,
    title,
    map: name,
    width,
    height,
    seed: seed.value,
    runs: runs.join(' '),
  })
}

function runWords(id: string, planner: string, result: RecordedResult | null): string {
  if (!result) return t('about.cite.setUp', { planner })
  const { iterations, length, digest } = result
  const words = length === null ? 'runNoPath' : 'run'
  const shown = length && Number(length.toPrecision(DIGITS))
  const told = { planner, length: shown, digest }
  // Searches count cells, which are not recorded.
  if (isSearch(id)) return t(`about.cite.${words}Search`, told)
  return t(`about.cite.${words}`, { ...told, count: iterations })
}
