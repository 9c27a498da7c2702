/** The places of an instance in an order: drawn, proven where they are few, and ordered by ants as one watches. */
import { Download, Pause, Play, RotateCcw, SkipForward } from 'lucide'
import { useEffect } from 'preact/hooks'
import '../styles/order.css'
import { t } from '../i18n/dialogs'
import { closeDialog } from '../state/dialogs'
import { type OrderPlay, orderPlay } from '../state/order_play'
import { Button } from '../ui/buttons'
import { Dialog } from '../ui/dialog'
import { FormError } from '../ui/form_error'
import { OrderCurve } from './order_curve'
import { saveOrder, saveRun } from './order_files'
import { OrderNumbers } from './order_numbers'
import { OrderPicture } from './order_picture'
import { OrderSettingFields } from './order_settings'

export function OrderDialog() {
  const play = orderPlay.value
  // Its worker ends with the dialog.
  useEffect(() => () => play?.end(), [play])
  if (!play) return null
  const error = play.error.value
  return (
    <Dialog
      title={t('order.title', { count: play.facts.value.places })}
      onClose={closeDialog}
      wide
      testId="order-dialog"
      actions={<Actions play={play} />}
    >
      <div class="order">
        <div class="order-view">
          <OrderPicture play={play} />
          <OrderCurve play={play} />
        </div>
        <OrderNumbers play={play} />
      </div>
      <OrderSettingFields play={play} />
      {error !== null && <FormError error={error} />}
    </Dialog>
  )
}

function Actions({ play }: { play: OrderPlay }) {
  const running = play.running.value
  const summary = play.summary.value
  const broken = play.error.value !== null
  return (
    <>
      <span class="order-files">
        <Button
          icon={Download}
          label={t('order.csv')}
          testId="order-csv"
          disabled={!summary?.best}
          onClick={() => saveOrder(play)}
        />
        <Button
          icon={Download}
          label={t('order.json')}
          testId="order-json"
          disabled={!summary?.best}
          onClick={() => saveRun(play)}
        />
      </span>
      <Button
        icon={RotateCcw}
        label={t('order.restart')}
        testId="order-restart"
        disabled={broken}
        onClick={() => play.restart()}
      />
      <Button
        icon={SkipForward}
        label={t('order.step')}
        testId="order-step"
        disabled={broken || play.isFinished()}
        onClick={() => play.step()}
      />
      <span class="order-run">
        <Button
          icon={running ? Pause : Play}
          label={t(running ? 'order.pause' : 'order.run')}
          tone="primary"
          testId="order-run"
          disabled={broken}
          onClick={() => play.toggle()}
        />
      </span>
    </>
  )
}
