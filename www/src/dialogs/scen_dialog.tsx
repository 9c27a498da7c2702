import { t } from '../i18n/dialogs'
import { type ScenChoice, scenChoice } from '../state'
import { chooseScen } from '../state/open_files'
import { Dialog } from '../ui/dialog'

/** The long and hard ones stand last, so the limit is high. */
const MOST_ROWS = 5000

export function ScenDialog({ choice }: { choice: ScenChoice }) {
  const { fileName, lines } = choice
  const close = () => {
    scenChoice.value = null
  }
  return (
    <Dialog title={t('scen.title')} onClose={close} testId="scen-dialog" wide>
      <p class="hint">{t('scen.count', { count: lines.length, name: fileName })}</p>
      <div class="table-scroll scen-rows">
        <table class="metrics">
          <thead>
            <tr>
              <th scope="col">#</th>
              <th scope="col">{t('scen.start')}</th>
              <th scope="col">{t('scen.goal')}</th>
              <th scope="col">{t('scen.optimal')}</th>
              <td />
            </tr>
          </thead>
          <tbody>
            {lines.slice(0, MOST_ROWS).map((line, index) => (
              <tr key={index}>
                <th scope="row">{index + 1}</th>
                <td>{line.start.join(', ')}</td>
                <td>{line.goal.join(', ')}</td>
                <td>{line.optimal}</td>
                <td>
                  <button type="button" class="link" onClick={() => chooseScen(line)}>
                    {t('scen.choose')}
                  </button>
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </Dialog>
  )
}
