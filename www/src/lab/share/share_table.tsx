/** A row a share: whether it is in, and the files that have brought it. */
import { Copy } from 'lucide'
import { t } from '../../i18n/lab'
import { shareText } from '../../share/share_of_class'
import { notify, notifyError } from '../../state'
import { CloseButton, IconButton } from '../../ui/buttons'
import { copyText } from '../../ui/copy_text'
import { removeBrought } from '../run/journals'
import type { ShareState } from '../run/shares'
import type { BroughtFile } from '../store/browser_storage'
import { linkOfQuestion, linkOfShare } from './class_links'
import { focusCollected } from './collected_focus'

/** As many rows as one still reads; what is missing beyond can be copied. */
const MOST_ROWS = 200

interface TableProps {
  of: number | null
  states: ShareState[]
  brought: BroughtFile[]
}

export function ShareTable({ of, states, brought }: TableProps) {
  const isOf = (file: BroughtFile) => states.some(({ files }) => files.includes(file))
  const others = brought.filter((file) => !isOf(file))
  if (states.length + others.length === 0) return null
  const more = states.length - MOST_ROWS
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: the keyboard must be able to scroll it
    <section class="result-scroll class-table" tabIndex={0} aria-label={t('lab.class.collected')}>
      <table class="result-table">
        <caption class="visually-hidden">{t('lab.class.collected')}</caption>
        <thead>
          <tr>
            <th scope="col">{t('lab.class.share')}</th>
            <th scope="col">{t('lab.class.state')}</th>
            <th scope="col">{t('lab.class.files')}</th>
          </tr>
        </thead>
        <tbody>
          {states.slice(0, MOST_ROWS).map((state) => (
            <ShareRow key={state.share} of={of ?? 0} state={state} />
          ))}
          {more > 0 && (
            <tr>
              <td colSpan={3}>{t('lab.class.moreRows', { count: more })}</td>
            </tr>
          )}
          {others.length > 0 && (
            <tr data-testid="class-others">
              <th scope="row">{t('lab.class.otherFiles')}</th>
              <td />
              <td>
                <Files files={others} />
              </td>
            </tr>
          )}
        </tbody>
      </table>
    </section>
  )
}

function ShareRow({ of, state }: { of: number; state: ShareState }) {
  const { share, runs, done, files } = state
  const is = done >= runs ? 'in' : done > 0 ? 'partly' : 'missing'
  const words = {
    in: () => t(files.length > 0 ? 'lab.class.isIn' : 'lab.class.doneHere'),
    partly: () => t('lab.class.isPart', { done, runs }),
    missing: () => t('lab.class.isMissing'),
  }[is]()
  return (
    <tr data-testid="class-share" data-state={is}>
      <th scope="row">{shareText({ index: share, of })}</th>
      <td>
        <span class={`chip class-is-${is}`}>{words}</span>
        {files.length > 1 && <span class="chip class-is-twice">{t('lab.class.twice')}</span>}
        {is !== 'in' && <CopyLink share={share} of={of} />}
      </td>
      <td>
        <Files files={files} />
      </td>
    </tr>
  )
}

function CopyLink({ share, of }: { share: number; of: number }) {
  const copy = async () => copyText(linkOfShare(await linkOfQuestion(), share, of))
  return (
    <IconButton
      icon={Copy}
      label={t('lab.class.copyLink', { share })}
      tone="quiet"
      size={14}
      testId="class-copy-link"
      onClick={() => void copy().catch(notifyError)}
    />
  )
}

function Files({ files }: { files: BroughtFile[] }) {
  if (files.length === 0) return null
  return (
    <ul class="class-files">
      {files.map((file) => (
        <li key={file.key} data-testid="class-file">
          <span>
            {t('lab.class.file', { name: file.name, count: file.runs })}
            {remarks(file).map((remark) => (
              <span key={remark} class="hint">
                {remark}
              </span>
            ))}
          </span>
          <CloseButton
            label={t('lab.class.remove', { name: file.name })}
            testId="class-remove"
            onClick={() => void remove(file).catch(notifyError)}
          />
        </li>
      ))}
    </ul>
  )
}

const remarks = ({ same, isCut }: BroughtFile): string[] => [
  ...(same > 0 ? [t('lab.class.same', { count: same })] : []),
  ...(isCut ? [t('lab.class.cut')] : []),
]

async function remove({ key, name, runs: count }: BroughtFile): Promise<void> {
  await removeBrought(key)
  focusCollected()
  notify('info', t('lab.class.removed', { name, count }))
}
