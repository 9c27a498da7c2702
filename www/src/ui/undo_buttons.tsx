/** Undo and redo, side by side. */
import { Redo2, Undo2 } from 'lucide'
import type { Undoing } from '../state'
import { IconButton } from './buttons'

interface UndoButtonsProps {
  of: Undoing
  /** Before `undo` and `redo`. */
  testId?: string
}

export function UndoButtons({ of, testId = '' }: UndoButtonsProps) {
  const words = of.words()
  return (
    <>
      <IconButton
        icon={Undo2}
        label={words.undo}
        keys="Ctrl+Z"
        testId={`${testId}undo`}
        disabled={!of.canUndo.value}
        onClick={of.undo}
      />
      <IconButton
        icon={Redo2}
        label={words.redo}
        keys="Ctrl+Shift+Z"
        testId={`${testId}redo`}
        disabled={!of.canRedo.value}
        onClick={of.redo}
      />
    </>
  )
}
