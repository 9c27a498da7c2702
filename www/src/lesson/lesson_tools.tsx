/** At the transport: stops, and the menu of what a lesson can do. */
import { Bot, CircleHelp, GraduationCap, Library, PencilLine, Pointer, Target } from 'lucide'
import { t } from '../i18n/lesson'
import { inRelief, lessonMode, panels, plannerEntry } from '../state'
import { show } from '../state/dialogs'
import { Icon } from '../ui/icon'
import { Menu, MenuItem } from '../ui/menu'
import { keepTaking, startDrawing } from './drawing'
import { follow, keepFollowing } from './follow'
import { keepAsking, startGuessing } from './guess'
import { keepMeasuring } from './hand_panel'
import { tellWhenMet } from './stop_words'
import { StopsMenu } from './stops_menu'

tellWhenMet()
keepFollowing()
keepAsking()
keepMeasuring()
keepTaking()

export function LessonTools() {
  return (
    <>
      <StopsMenu />
      <Menu
        label={t('lesson.menu')}
        face={<Icon icon={GraduationCap} />}
        testId="lesson-menu"
        align="end"
        bare
      >
        <MenuItem
          icon={Pointer}
          label={t('lesson.items.follow')}
          note={t('lesson.items.followNote')}
          unavailable={withoutAnts()}
          testId="lesson-follow"
          onClick={() => withAnts((panelId) => follow(panelId, 0))}
        />
        <MenuItem
          icon={CircleHelp}
          label={t('lesson.items.guess')}
          note={t('lesson.items.guessNote')}
          unavailable={withoutAnts()}
          testId="lesson-guess"
          onClick={() => withAnts((panelId) => startGuessing(panelId, 0))}
        />
        <MenuItem
          icon={PencilLine}
          label={t('lesson.items.draw')}
          note={t('lesson.items.drawNote')}
          unavailable={withoutMap()}
          testId="lesson-draw"
          onClick={() => startDrawing(panels.peek()[0]?.id ?? 0)}
        />
        <MenuItem
          icon={Bot}
          label={t('lesson.items.drive')}
          note={t('lesson.items.driveNote')}
          unavailable={withoutMap()}
          testId="lesson-drive"
          onClick={() => {
            lessonMode.value = 'drive'
          }}
        />
        <MenuItem
          icon={Target}
          label={t('lesson.items.target')}
          note={t('lesson.items.targetNote')}
          testId="lesson-target"
          onClick={() => show('share')}
        />
        <MenuItem
          icon={Library}
          label={t('lesson.items.gallery')}
          note={t('lesson.items.galleryNote')}
          testId="lesson-gallery"
          onClick={() => show('lessons')}
        />
      </Menu>
    </>
  )
}

/** The first panel with ants. */
const antPanel = () =>
  panels.value.find(({ setup }) => plannerEntry(setup.planner)?.family === 'ant-colony')

function withAnts(begin: (panelId: number) => void): void {
  const panel = antPanel()
  if (panel) begin(panel.id)
}

function withoutAnts(): string | null {
  if (!antPanel()) return t('lesson.items.needsAnts')
  return inRelief.value ? t('lesson.items.needsFlat') : null
}

function withoutMap(): string | null {
  if (panels.value.length === 0) return t('lesson.items.needsPanel')
  return inRelief.value ? t('lesson.items.needsFlat') : null
}
