/** Shares out the runs of the open comparison: how many shares, and their links. */
import { ArrowLeft, Copy, FileDown } from 'lucide'
import type { ComponentChildren } from 'preact'
import { useState } from 'preact/hooks'
import { isTooLong, type Link, useLink } from '../../dialogs/send_dialog'
import { numbers } from '../../i18n'
import { t } from '../../i18n/lab'
import { PREFIX } from '../../share/comparison_link'
import { LINK_LIMIT } from '../../share/envelope'
import { notifyError } from '../../state'
import { download } from '../../state/export_files'
import { Button } from '../../ui/buttons'
import { copyText } from '../../ui/copy_text'
import { Dialog } from '../../ui/dialog'
import { openComparison, phase } from '../run/actions'
import { chooseShare, dealTo, runsOfQuestion, sizeOfShares } from '../run/shares'
import { timeWords } from '../run/time_words'
import { fileStem } from '../store/names'
import { linkOfShare, textOfQuestion } from './class_links'

export const LEAST_SHARES = 2
const USUAL_SHARES = 30
/** As many links as are shown; the file and what is copied have them all. */
const SHOWN_LINKS = 3

export function ClassDialog({ onBack, onClose }: { onBack: () => void; onClose: () => void }) {
  const now = openComparison.value
  const { all: runs } = runsOfQuestion()
  const most = Math.min(now?.mostShares ?? LEAST_SHARES, runs)
  const [of, setOf] = useState(Math.min(now?.dealt ?? USUAL_SHARES, most))
  const link = useLink(PREFIX, textOfQuestion)
  const whole = (count: number) => numbers.value.whole.format(count)
  return (
    <Dialog
      title={t('lab.class.title')}
      onClose={onClose}
      testId="class-dialog"
      actions={
        <Button
          icon={ArrowLeft}
          label={t('lab.class.back')}
          tone="quiet"
          testId="class-back"
          onClick={onBack}
        />
      }
    >
      <p>{t('lab.class.what', { runs: whole(runs) })}</p>
      <label class="class-number">
        {t('lab.class.shares')}
        <input
          class="input"
          type="number"
          min={LEAST_SHARES}
          max={most}
          value={of}
          data-testid="class-shares"
          onInput={({ currentTarget: { valueAsNumber } }) => {
            if (valueAsNumber >= LEAST_SHARES) setOf(Math.min(Math.floor(valueAsNumber), most))
          }}
        />
        <span class="hint">
          {t('lab.class.sharesHint', { least: LEAST_SHARES, most: whole(most) })}
        </span>
      </label>
      <p class="hint" role="status" data-testid="class-size">
        {sizeWords(of)}
      </p>
      <Links link={link} of={of} />
      {phase.value !== 'running' && <Here of={of} onClose={onClose} />}
    </Dialog>
  )
}

/** How many runs a share has, and about how long it takes. */
function sizeWords(of: number): string {
  const { runs, seconds } = sizeOfShares(of)
  const time = seconds === null ? t('lab.class.sizeUnknown') : timeWords(seconds, 'ofShare')
  return `${t('lab.class.size', { count: runs })} ${time}`
}

function Links({ link, of }: { link: Link; of: number }) {
  if (link === null) return <p class="hint">{t('common.working')}</p>
  const one = linkOfShare(link, null, of)
  if (isTooLong(link) || isTooLong(one)) {
    const { whole } = numbers.value
    const lengths = { length: whole.format(one.length), limit: whole.format(LINK_LIMIT) }
    return (
      <p class="banner" data-testid="class-too-long">
        {t('lab.class.tooLong', lengths)}
      </p>
    )
  }
  const linksOf = (count: number) =>
    Array.from({ length: count }, (_, at) => linkOfShare(link, at + 1, of)).join('\n')
  const deal = () => void dealTo(of).catch(notifyError)
  return (
    <>
      <Given title={t('lab.class.oneLink')}>
        <input
          class="input share-link"
          readOnly
          value={one}
          aria-label={t('lab.class.oneLink')}
          data-testid="class-link"
          onFocus={(event) => event.currentTarget.select()}
          onCopy={deal}
        />
        <Button
          icon={Copy}
          label={t('lab.class.copyOne')}
          tone="primary"
          testId="class-copy"
          onClick={() => {
            deal()
            void copyText(one)
          }}
        />
      </Given>
      <Given title={t('lab.class.links', { count: of })}>
        <pre class="class-links" data-testid="class-links">
          {`${linksOf(Math.min(of, SHOWN_LINKS))}${of > SHOWN_LINKS ? '\n…' : ''}`}
        </pre>
        <div class="class-row">
          <Button
            icon={Copy}
            label={t('lab.class.copyAll', { count: of })}
            testId="class-copy-all"
            onClick={() => {
              deal()
              void copyText(linksOf(of))
            }}
          />
          <Button
            icon={FileDown}
            label={t('lab.class.saveAll')}
            testId="class-save-all"
            onClick={() => {
              deal()
              const stem = fileStem(openComparison.peek()?.title ?? '')
              download(`${stem}.shares.txt`, `${linksOf(of)}\n`)
            }}
          />
        </div>
      </Given>
    </>
  )
}

function Given({ title, children }: { title: string; children: ComponentChildren }) {
  return (
    <section class="class-given">
      <h3>{title}</h3>
      {children}
    </section>
  )
}

/** For who got the comparison as a file, in which there is no share. */
function Here({ of, onClose }: { of: number; onClose: () => void }) {
  return (
    <section class="class-given">
      <Button
        label={t('lab.class.here')}
        testId="class-here"
        onClick={() => {
          void chooseShare({ index: null, of }).catch(notifyError)
          onClose()
        }}
      />
      <p class="hint">{t('lab.class.hereHint')}</p>
    </section>
  )
}
